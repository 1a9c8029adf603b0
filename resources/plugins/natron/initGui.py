"""Read by Natron at its start, where this folder is on its plug-in path: the menu ROAM."""

import NatronGui
import roam_natron  # noqa: F401 - Natron runs the commands below where this name is known

NatronGui.natron.addMenuCommand("ROAM/Send plate and shapes to ROAM", "roam_natron.send()")
NatronGui.natron.addMenuCommand("ROAM/Bring shapes back from ROAM", "roam_natron.bring()")

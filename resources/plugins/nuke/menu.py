"""Read by Nuke at its start, where this folder is on its plug-in path: the menu ROAM."""

import nuke
import roam_nuke

_menu = nuke.menu("Nuke").addMenu("ROAM")
_menu.addCommand("Send plate and shapes to ROAM", roam_nuke.send)
_menu.addCommand("Bring shapes back from ROAM", roam_nuke.bring)

"""Names of colour spaces: which a plate may have, and which one its file, its metadata or an artist means."""

from __future__ import annotations

import os
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.media.curves import COLOUR_SPACES
from roam_core.translatable import said_by, sentence

# OpenColorIO is a large library: it is loaded for plates that need more than ROAM's own spaces.


def known_space(name: str) -> str:
    """The colour space that a name, alias or role means, in capitals or not, as OpenColorIO takes its own.

    Raises
    ------
    RoamError
        when there is none; the sentence names some.
    """
    if name in COLOUR_SPACES:
        return name
    from roam_core.media import colour_config

    found = colour_config.named(name)
    if found is None:
        found = next((space for space in COLOUR_SPACES if space.casefold() == name.casefold()), None)
    if found is None:
        raise RoamError(
            sentence(
                "The colour space {name!r} is not known; choose one of {spaces}, "
                "or of the OpenColorIO configuration: {others}.",
                name=name,
                spaces=", ".join(COLOUR_SPACES),
                others=", ".join(colour_config.space_names()),
            )
        )
    return found


def definition_of(space: str) -> str:
    """What tells a space from another of its name, in another `$OCIO`; "" for ROAM's own and for the built-in ones."""
    if space in COLOUR_SPACES or not os.environ.get("OCIO"):
        return ""
    from roam_core.media import colour_config

    return colour_config.definition_of(space)


def offered_spaces() -> tuple[str, ...]:
    """All colour spaces that a plate may be said to have: ROAM's own, then those of the configuration if it is read."""
    from roam_core.media.colour_config import space_names

    try:
        return (*COLOUR_SPACES, *space_names())
    except RoamError:
        return COLOUR_SPACES


def offered_views() -> tuple[tuple[str, str], ...]:
    """The displays of the configuration, each with each of its views. Raises `RoamError` where it cannot be read."""
    from roam_core.media.colour_config import views

    return views()


def config_name() -> str:
    """What tells the configuration of OpenColorIO from others: the text of `$OCIO`; "" for the built-in one."""
    return os.environ.get("OCIO", "")


def space_called(name: str) -> str | None:
    """The colour space that a file calls so; None where the configuration knows none of that name."""
    from roam_core.media.colour_config import named

    return named(name)


def space_by_rule(file: Path) -> str | None:
    """The colour space that the rules of the studio's configuration give a file by its name, if they do."""
    if not os.environ.get("OCIO"):
        return None
    from roam_core.media.colour_config import by_rule

    return by_rule(file)


def config_trouble() -> str:
    """Why the studio's configuration tells the space of no plate: a sentence; "" where it is read, or `$OCIO` unset."""
    if not os.environ.get("OCIO"):
        return ""
    try:
        offered_views()
    except RoamError as error:
        return said_by(error)
    return ""


def space_with_primaries(chromaticities: object) -> str | None:
    """The scene-linear space with the primaries that an EXR tells; None where it is Rec. 709's, or none is known."""
    from roam_core.media.colour_config import with_primaries

    return with_primaries(chromaticities)

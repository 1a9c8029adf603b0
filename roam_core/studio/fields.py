"""What a file of jobs may say, as tables: the reader and the schema are both made from them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any

from roam_core.errors import RoamError
from roam_core.interchange.matte_style import COMPRESSIONS, Depth, MatteFile, Parts
from roam_core.interchange.protocol import KeyChoice


class Kind(Enum):
    """What a value of a file of jobs is; the value of a member is the schema of it."""

    TEXT = {"type": "string", "minLength": 1}  # noqa: RUF012 - a member, not a field
    WHOLE = {"type": "integer"}  # noqa: RUF012
    NUMBER = {"type": "number"}  # noqa: RUF012
    FLAG = {"type": "boolean"}  # noqa: RUF012
    TEXTS = {"type": "array", "items": {"type": "string", "minLength": 1}, "minItems": 1}  # noqa: RUF012


_WORDS = {
    Kind.TEXT: "a text",
    Kind.WHOLE: "a whole number",
    Kind.NUMBER: "a number",
    Kind.FLAG: "true or false",
    Kind.TEXTS: "a list of texts",
}


@dataclass(frozen=True)
class Field:
    """A value by its name; `choices` are the texts that it may be, none for any."""

    name: str
    kind: Kind
    meaning: str
    choices: tuple[str, ...] = ()
    needed: bool = False

    @property
    def schema(self) -> dict[str, Any]:
        """The field in words of JSON Schema."""
        among = {"enum": list(self.choices)} if self.choices else {}
        return {**self.kind.value, **among, "description": self.meaning}

    def require(self, value: Any, where: str) -> None:
        """Raise `RoamError` where a value is not of this field's kind."""
        if not _is_of(value, self.kind):
            raise RoamError(f"{where}.{self.name} is {_shown(value)}; it has to be {_WORDS[self.kind]}.")
        if self.choices and value not in self.choices:
            raise RoamError(f"{where}.{self.name} is {_shown(value)}; it has to be one of {', '.join(self.choices)}.")


@dataclass(frozen=True)
class Verb:
    """A step's command: what may be said of it, and whether it makes a project."""

    meaning: str
    fields: tuple[Field, ...]
    makes_project: bool


_CONFIG = Field("config", Kind.TEXT, "the engine's configuration, with dials, such as best+smoothness=2")
_SHAPE = Field("shape", Kind.TEXTS, "names or ids of the shapes (all)")
_ALONE = Field("alone", Kind.FLAG, "solve each shape as if its object had no others")
_KEYS = tuple(choice.value for choice in KeyChoice)
_COMPRESSIONS = tuple(sorted({word for words in COMPRESSIONS.values() for word in words}))

VERBS: dict[str, Verb] = {
    "track": Verb(
        "carry the shapes of `init`, or of the step before, through the clip",
        (
            _CONFIG,
            Field("start", Kind.WHOLE, "frame to start from (a project: its first key; a mask: the first frame)"),
            Field("end", Kind.WHOLE, "last frame (the clip's last)"),
            Field("backward", Kind.FLAG, "to earlier frames"),
            _SHAPE,
            _ALONE,
        ),
        makes_project=True,
    ),
    "fill": Verb(
        "engine keys between the artist's keys, spread over the workers gap by gap and object by object",
        (_CONFIG, _SHAPE, _ALONE),
        makes_project=True,
    ),
    "steady": Verb(
        "tracked and filled keys moved so that their outlines boil less",
        (
            Field("strength", Kind.NUMBER, "from 0, nothing, to 1"),
            Field("start", Kind.WHOLE, "first frame (the first with a tracked key)"),
            Field("end", Kind.WHOLE, "last frame (the last with a tracked key)"),
            _SHAPE,
        ),
        makes_project=True,
    ),
    "soften": Verb(
        "motion blur and feather as the plate's edges have them",
        (Field("by", Kind.TEXT, "what the softness becomes", ("both", "motion-blur", "feather")), _SHAPE),
        makes_project=True,
    ),
    "shift": Verb(
        "all frames of the project later or earlier, or as its plate was renumbered",
        (Field("by", Kind.WHOLE, "frames later, below zero earlier (as the plate was renumbered)"), _SHAPE),
        makes_project=True,
    ),
    "import": Verb(
        "shapes of another program's file, or of a folder of mattes, on top of those that are there",
        (
            Field("source", Kind.TEXT, "the file, or the folder of mattes", needed=True),
            Field("tolerance", Kind.NUMBER, "mattes: pixels by which curves may stray"),
            Field("keys", Kind.TEXT, "mattes: a key on every frame, or few", (_KEYS[0], _KEYS[2])),
            Field("speckle", Kind.NUMBER, "mattes: leave out what is smaller, in square pixels"),
            Field("frame-offset", Kind.WHOLE, "what was added to the frame numbers on export"),
        ),
        makes_project=True,
    ),
    "render": Verb(
        "mattes, into the folder `mattes` of the job",
        (
            Field("start", Kind.WHOLE, "first frame (the clip's first)"),
            Field("end", Kind.WHOLE, "last frame (the clip's last)"),
            Field("name", Kind.TEXT, "pattern of the files' names, such as hero.####.exr"),
            _SHAPE,
            Field("file", Kind.TEXT, "kind of the pictures", tuple(MatteFile)),
            Field("depth", Kind.TEXT, "bits, or floating point", tuple(Depth)),
            Field("compression", Kind.TEXT, "without loss in any case", _COMPRESSIONS),
            Field("per", Kind.TEXT, "what has a matte of its own", tuple(Parts)),
            Field("channels", Kind.FLAG, "exr: layers or shapes as channels of one file"),
            Field("cryptomatte", Kind.FLAG, "exr: shapes and layers as Cryptomatte, by name"),
            Field("tight", Kind.FLAG, "exr: leave out the black around the shapes"),
        ),
        makes_project=False,
    ),
    "export": Verb(
        "shapes for another program, into the folder of the job",
        (
            Field("to", Kind.TEXT, "the format, as `roam export --to` takes it", needed=True),
            Field("keys", Kind.TEXT, "which keys", _KEYS),
            Field("tolerance", Kind.NUMBER, "pixels, for reduced keys"),
            Field("smooth", Kind.NUMBER, "let tracked keys move by up to so many pixels"),
            Field("frame-offset", Kind.WHOLE, "added to every frame number"),
            Field("lossy", Kind.FLAG, "write even where the mattes would differ in the other program"),
            _SHAPE,
        ),
        makes_project=False,
    ),
}
"""The steps of a job, by the name of the command that carries each out."""

JOB_FIELDS = (
    Field("name", Kind.TEXT, "of the job, and of its folder of results", needed=True),
    Field("clip", Kind.TEXT, "folder of images, pattern or movie (of a project as `init`: its own)"),
    Field("init", Kind.TEXT, "a mask of the first frame, or a .roam project"),
    Field("layer", Kind.TEXT, "layer of the clip's EXR files (found)"),
    Field("colour", Kind.TEXT, "colour space of the clip (found)"),
)
FILE_FIELDS = (Field("out", Kind.TEXT, "folder of all results (beside the file, named as it is)"),)


def require_fields(values: Mapping[str, Any], fields: Sequence[Field], where: str, others: Sequence[str] = ()) -> None:
    """Raise `RoamError` where a mapping holds what no field is, lacks one that is needed, or holds a wrong value."""
    known = {field.name: field for field in fields}
    for name in values:
        if name not in known and name not in others:
            raise RoamError(
                f"{where} has {_shown(name)}, which means nothing there; it may have {_listed(fields, others)}."
            )
    for field in fields:
        if field.name in values:
            field.require(values[field.name], where)
        elif field.needed:
            raise RoamError(f"{where} has no {field.name!r}: {field.meaning}.")


def schema() -> dict[str, Any]:
    """The schema of a file of jobs, JSON Schema of 2020-12: for editors, and for programs that write such files."""
    steps = {"type": "array", "items": {"$ref": "#/$defs/step"}, "minItems": 1}
    job = _object(JOB_FIELDS, {"steps": steps})
    verbs = [
        {**_object((), {name: _object(verb.fields, {})}), "required": [name], "description": verb.meaning}
        for name, verb in VERBS.items()
    ]
    plain = [name for name, verb in VERBS.items() if not any(field.needed for field in verb.fields)]
    top = _object(
        FILE_FIELDS,
        {
            "type": {"const": "roam.Jobs"},
            "version": {"const": 1},
            "steps": {**steps, "description": "the steps of jobs that name none"},
            "jobs": {"type": "array", "items": job, "minItems": 1},
        },
    )
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Jobs of roam batch",
        **top,
        "required": ["type", "version", "jobs"],
        "$defs": {"step": {"oneOf": [{"enum": plain}, *verbs]}},
    }


def _object(fields: Sequence[Field], others: Mapping[str, Any]) -> dict[str, Any]:
    made: dict[str, Any] = {
        "type": "object",
        "properties": {**{field.name: field.schema for field in fields}, **others},
        "additionalProperties": False,
    }
    needed = [field.name for field in fields if field.needed]
    return {**made, "required": needed} if needed else made


def _is_of(value: Any, kind: Kind) -> bool:
    is_whole = isinstance(value, int) and not isinstance(value, bool)
    if kind is Kind.WHOLE:
        return is_whole
    if kind is Kind.NUMBER:
        return is_whole or (isinstance(value, float) and math.isfinite(value))
    if kind is Kind.FLAG:
        return isinstance(value, bool)
    if kind is Kind.TEXTS:
        return isinstance(value, list) and bool(value) and all(_is_of(each, Kind.TEXT) for each in value)
    return isinstance(value, str) and bool(value) and value.isprintable()


def _listed(fields: Sequence[Field], others: Sequence[str]) -> str:
    return ", ".join([*(field.name for field in fields), *others]) or "nothing"


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."

"""The user's plant: its PLC, gateways, drives and sequences."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog import AccessWay, Catalog, Located, OptionValue
from fbgen.catalog.scalars import Flag, Real, Text, Whole
from fbgen.diagnostics import Diagnostic
from fbgen.plant import checks

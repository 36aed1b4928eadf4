"""Words, in English, German and French, and how units are written: the tables that ``vocabulary`` reads by.

A word with "=" stands alone; another may stand within a longer one.
"""

from __future__ import annotations

import re
from math import inf

LENGTHS = ("contraction", "length", "ratio")
UNITS = {
    "time": "s",
    "pressure": "Pa",
    "contraction": "m",
    "length": "m",
    "ratio": "1",
    "force": "N",
    "mass": "kg",
    "temperature": "K",
    "current": "A",
    "command": "1",
    "voltage": "V",
    "angle": "rad",
    "count": "1",
    "direction": "1",
}
"""What can be measured, and its SI unit."""

KINDS = {
    "time": "=t =time =zeit =temps =sec =sek time zeit temps elapsed",
    "pressure": "=p =pm =pk =ps =pset =psoll =psp =pref =pcmd =psup =psupply =psource =pamb =patm =baro =pist "
    "=pmus =pmuscle =pdes =pact barometer "
    "barometr pressure druck pression press",
    "temperature": "=t =tamb =temp temperature temperatur thermo",
    "current": "=i =u =strom =courant current strom courant intensite",
    "command": "valve ventil vanne schalt switch solenoid =pwm duty command befehl commande relais relay =cmd =u",
    "force": "=f =fz =fx =last =load =charge force kraft effort loadcell kraftmess zugkraft =pull =traction",
    "ratio": "=eps epsilon strain ratio dehnung stauchung verhaltnis",
    "contraction": "=x =s =z =y =dx =dl =weg =hub =pos =disp contraction kontraktion displacement "
    "verschiebung verkurzung verkuerzung raccourcissement deplacement stroke position weggeber "
    "wegsensor laser course travel shortening",
    "length": "=l =len =lange length laenge lange longueur",
    "mass": "=mass =masse =gewicht weight gewicht poids",
    "angle": "angle winkel",
    "voltage": "voltage spannung",
    "count": "cycle zyklus takt index sample trial versuch number nummer numero =no =nr =n =id =point =punkt =lauf",
    "direction": "=dir direction richtung =branch =zweig =ast =sens =phase =hysteresis hysterese inflat deflat loading",
}
ROLES = {
    "supply": "supply source versorgung vordruck netzdruck alimentation reservoir tank upstream kessel =sup =src =ps "
    "=psup",
    "set": "=set =sp =soll =ref =cmd =pset =psoll =psp =pref =pcmd =pdes setpoint soll "
    "consigne target desired reference wanted demand told command befehl",
    "inlet": "=in =inl =ein inlet intake einlass zuluft admission beluft belueft fill fullen gonflage remplissage",
    "exhaust": "=out =ex =exh =aus =vent exhaust outlet auslass abluft entluft entlueft echappement purge vidange",
    "ambient": "ambient room umgebung raumtemp raumluft ambiant atmos outside labor =amb =tamb =pamb =patm =atm =umg "
    "=baro barometer barometr",
}
COUNTS = "count counts bit bits digit digits lsb px pix pixel pixels mv/v"
"""Units, folded, that a converter, a camera or a bridge of strain gauges gives."""
MEASURED_IN_COUNTS = frozenset(("pressure", "force", "contraction", "length"))
TRANSMITTED = MEASURED_IN_COUNTS | {"temperature"}
NEEDING_UNITS = TRANSMITTED | {"mass", "current", "time"}
ATMOSPHERE = "atm"
ANY_PRESSURE = ("p", "press", "pressure", "druck", "pression")
"""Words, folded, for no pressure in particular: behind one of them "atm" says which, behind others it is a unit."""
WITHOUT_ROLES = ("count", "direction")
OF_VALVES = ("inlet", "exhaust")
SAYS_SURELY = {
    "pressure": re.compile(r".*druck|pressure|pression"),
    "force": re.compile(r".*kraft|force|loadcell"),
    "temperature": re.compile(r".*temperatur|temperature"),
}
"""Words, folded, that leave no doubt of what a column is: "compression" does, and a "load" may be a voltage."""
SAID_IN_PASSING = frozenset(
    ["a", "as", "at", "by", "in", "is", "it", "of", "off", "on", "out", "that", "the", "to", "up"]
)
# "unloading" and "entlasten" hold words of the other way: these come first.
DIRECTIONS = (
    (
        -1,
        "deflat =down =d =ab abwarts =fall falling decreas unload entlast entluft release =vent venting exhaust "
        "extend extension =ruck ruckhub descen degonfl =back backward return =out",
    ),
    (
        1,
        "inflat =up =u =auf aufwarts =rise rising increas load belast beluft press fill contract =hin hinhub mont "
        "gonfl =forward =in",
    ),
)
NO_LOAD = (
    "noload",
    "unload",
    "lastfrei",
    "unbelastet",
    "leerhub",
    "freehub",
    "freestroke",
    "sanscharge",
    "zeroload",
)
STANDS_FOR = {"ratio": ("contraction", "length"), "mass": ("force",), "current": ("command",)}
"""What is also measured in the units of a kind: shares of a length, what hangs on a muscle, what drives a valve."""
_WRITTEN = {
    "bar": "bar",
    "kPa": "kpa",
    "hPa": "hpa",
    "Pa": "pa",
    "psi": "psi",
    "kgf/cm2": "kgf/cm2, kg/cm2, kg/cm^2, kp/cm2",
    "lbf/in2": "lb/in2, lbs/in2, lb/in^2, lbs/in^2",
    "s": "sec, sek, sek., secs, seconds, sekunden, secondes",
    "ms": "msec",
    "MPa": "mpa",
    "mbar": "mbar",
    "N": "newton, n",
    "kN": "kn",
    "torr": "torr",
    "degC": "celsius, c, degc, grad c, deg c",
    "degF": "fahrenheit, f, degf, grad f, deg f",
    "kg": "kg",
    "A": "ampere, amp, a",
    "mA": "ma",
    "V": "volt, volts, v",
    "mm": "mm, millimeter",
    "inch": "inch, in., zoll, \", ''",
    "cm": "cm",
    "%": "prozent, percent, pct",
    "K": "kelvin",
}
"""How units are written beside their own way, folded."""
SPELLINGS = {written: unit for unit, several in _WRITTEN.items() for written in several.split(", ")}
ABSOLUTE = re.compile(r"abs|pabs|absol.*")
"""A word, folded, that says of a pressure that it is absolute; "Absperrventil" and "Abstand" do not."""


# Unit that numbers without one most likely have, by their largest magnitude: of a laboratory's muscle.
USUAL_UNITS: dict[str, tuple[tuple[float, str], ...]] = {
    "pressure": ((1.2, "MPa"), (15.0, "bar"), (2e3, "kPa"), (inf, "Pa")),
    "ambient pressure": ((1.2, "bar"), (16.0, "psi"), (120.0, "kPa"), (1.2e3, "hPa"), (inf, "Pa")),
    "contraction": ((0.7, "m"), (inf, "mm")),
    "length": ((0.7, "m"), (inf, "mm")),
    "ratio": ((1.0, ""), (inf, "%")),
    "command": ((1.0, ""), (120.0, "%")),  # more is in steps of a converter
    "force": ((inf, "N"),),
    "mass": ((inf, "kg"),),
    "temperature": ((200.0, "degC"), (inf, "K")),
    "current": ((2.0, "A"), (inf, "mA")),
}

# Unit of whole numbers of time, by what they begin with, since 1970, or else by the step from row to row: a recording
# of a muscle has several rows a second.
USUAL_EPOCHS = ((1e11, ""), (1e14, "ms"), (1e17, "us"), (inf, "ns"))
USUAL_STEPS = ((1e3, "ms"), (1e6, "us"), (inf, "ns"))
# Days since 1900, as spreadsheets count them, of recordings since 1982.
DAYS = (30e3, 80e3)
SHORTEST_STEP = 1e-5  # [s] of such numbers, if they were seconds
SHORTEST_RECORDING = 0.1  # [s] of shares of a day, if they were seconds; no muscle is done so soon

"""Effects that belong to none of the sixteen families: the right answer is that something unknown is missing.

Each is kept away from what a family says. A spring, a friction, a mass, a valve that opens late or by another law, a
line, a leak, heat, a slow thermometer, a constant error of the pressure reading are families and do not occur here.
Most follow the clock, the command or something outside the rig, so that no term of a balance could stand for them.
"""

from rig.seen.none_of_these.gas import (
    BufferTank,
    EmptyBottle,
    HeatLamp,
    LooseContact,
    PumpingSupply,
    SecondConsumer,
    StickyValves,
    WarmCoils,
)
from rig.seen.none_of_these.instruments import (
    ClockSkew,
    CrossTalk,
    DriftingRuler,
    EncoderError,
    FilteredRuler,
    MainsHum,
    OwnClock,
    SaggingExcitation,
    SelfHeating,
    SensorBacklash,
    SlippedRuler,
    SnubbedManometer,
    WarmingJunction,
)
from rig.seen.none_of_these.loads import (
    Coupled,
    ForceRipple,
    HoldingMagnet,
    Nudge,
    ObliqueString,
    RestlessStart,
    Ripple,
    SecondWeight,
    SpringLoad,
    Vibration,
)

__all__ = [
    "BufferTank",
    "ClockSkew",
    "Coupled",
    "CrossTalk",
    "DriftingRuler",
    "EmptyBottle",
    "EncoderError",
    "FilteredRuler",
    "ForceRipple",
    "HeatLamp",
    "HoldingMagnet",
    "LooseContact",
    "MainsHum",
    "Nudge",
    "ObliqueString",
    "OwnClock",
    "PumpingSupply",
    "RestlessStart",
    "Ripple",
    "SaggingExcitation",
    "SecondConsumer",
    "SecondWeight",
    "SelfHeating",
    "SensorBacklash",
    "SlippedRuler",
    "SnubbedManometer",
    "SpringLoad",
    "StickyValves",
    "Vibration",
    "WarmCoils",
    "WarmingJunction",
]

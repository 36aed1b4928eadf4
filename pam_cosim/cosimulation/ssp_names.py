"""Names of the System Structure and Parameterization standard, SSP 1.0 and 2.0: the later one kept the namespaces."""

DESCRIPTION = "SystemStructure.ssd"
NAMESPACES = {
    "ssd": "http://ssp-standard.org/SSP1/SystemStructureDescription",
    "ssc": "http://ssp-standard.org/SSP1/SystemStructureCommon",
    "ssv": "http://ssp-standard.org/SSP1/SystemStructureParameterValues",
    "ssm": "http://ssp-standard.org/SSP1/SystemStructureParameterMapping",
}
FMU_TYPE = "application/x-fmu-sharedlibrary"
VERSIONS = ("1.0", "2.0")


def tag(prefix: str, name: str) -> str:
    """An element's name as ElementTree has it."""
    return f"{{{NAMESPACES[prefix]}}}{name}"

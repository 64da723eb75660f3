"""Finds out what kind of log a file is."""

from __future__ import annotations

from occgrid_parity.logs.bag_log import BagLog
from occgrid_parity.logs.bag_messages import is_bag
from occgrid_parity.logs.carmen_log import CarmenLog
from occgrid_parity.logs.conversion import ConversionError, Request, Source


def open_log(request: Request) -> Source:
    """The log as a source of scans.

    Raises ConversionError where a bag is asked for lines, or a text log for topics.
    """
    if is_bag(request.log):
        if request.all_lines:
            raise ConversionError(
                f"{request.log}: a bag has no lines for --all-lines"
            )
        return BagLog(request)
    if request.topic is not None or request.frame is not None:
        raise ConversionError(
            f"{request.log}: --topic and --frame are for ROS bags, which end with .bag, .mcap or .db3 or are "
            "a folder"
        )
    return CarmenLog(request)

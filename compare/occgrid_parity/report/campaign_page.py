"""The page of a campaign."""

from __future__ import annotations

from pathlib import Path

from markupsafe import Markup

from occgrid_parity.campaign.campaign_record import CampaignRecord
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.report.campaign_table import summary
from occgrid_parity.report.run_page import PAGE_FILE, asset, environment


def write_campaign_page(record: CampaignRecord, target: Path) -> Path:
    """Writes the page into a folder, which is made where it is missing; returns its file."""
    text = (
        environment()
        .get_template("campaign.html")
        .render(
            record=record,
            summary=summary(record),
            style=Markup(asset("page.css")),
        )
    )
    target.mkdir(parents=True, exist_ok=True)
    page = target / PAGE_FILE
    write_text(page, text)
    return page

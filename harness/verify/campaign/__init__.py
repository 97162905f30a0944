"""Campaigns: many seeds of random faults on plants and scenarios, each failure made short."""

from harness.verify.campaign.campaign import Campaign, CampaignReport, Progressed
from harness.verify.campaign.trials import CampaignSettings, Failure

__all__ = ["Campaign", "CampaignReport", "CampaignSettings", "Failure", "Progressed"]

"""What commands leave for people, code hosts and other programs: pages, lists, formats."""

"""What a result says to people: report, damage, alarms."""

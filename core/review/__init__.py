"""A person's decisions and corrections on a result; sqlite3 and numpy only."""

"""What every package of core uses; knows nothing of tetrapods."""

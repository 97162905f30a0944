"""Torque and current of motor and load."""

import pytest

from harness.drives import Load, LoadShape, Motor

MOTOR = Motor()


@pytest.mark.parametrize("shape", LoadShape)
def test_load_of_the_manual_example_draws_43_28_percent_at_50_hz(shape: LoadShape) -> None:
    torque = Load(32.7, shape).torque_at(50.0)
    assert round(MOTOR.current_percent(torque, 50.0), 2) == 43.28


def test_rated_torque_draws_the_rated_current_and_no_load_the_magnetising_current() -> None:
    assert MOTOR.current_percent(100.0, 50.0) == pytest.approx(100.0)
    assert MOTOR.current_percent(0.0, 50.0) == pytest.approx(30.0)


@pytest.mark.parametrize(
    ("shape", "expected"),
    [(LoadShape.CONSTANT, 80.0), (LoadShape.LINEAR, 40.0), (LoadShape.QUADRATIC, 20.0)],
)
def test_torque_depends_on_speed_as_the_shape_says(shape: LoadShape, expected: float) -> None:
    load = Load(80.0, shape)
    assert load.torque_at(25.0) == pytest.approx(expected)
    assert load.torque_at(-25.0) == pytest.approx(expected)


def test_accelerating_takes_torque_for_the_inertia() -> None:
    load = Load(10.0, inertia_percent_s=4.0)
    assert load.torque_at(20.0, slope=5.0) == pytest.approx(30.0)
    assert load.torque_at(20.0, slope=-5.0) == pytest.approx(-10.0)


def test_load_at_rest_needs_no_torque() -> None:
    assert Load(50.0).torque_at(0.0) == 0.0


def test_above_the_base_frequency_the_flux_falls_and_torque_costs_more_current() -> None:
    assert MOTOR.exciting_current_percent(100.0) == pytest.approx(15.0)
    assert MOTOR.torque_current_percent(50.0, 100.0) == pytest.approx(
        2 * MOTOR.torque_current_percent(50.0, 50.0)
    )
    assert MOTOR.voltage_percent(100.0) == 100.0
    assert MOTOR.voltage_percent(-25.0) == 50.0

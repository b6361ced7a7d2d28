//! The instrument's temperature, five times a second, and an end to what runs when
//! it is out of range.

use crate::board::{NotReady, SensorConverter, factory_codes};
use crate::state::{self, Order};
use calib_core::point_state::Reason;
use calib_core::thermometer::{Thermometer, may_work_at};
use embassy_time::{Duration, Ticker, Timer};

/// A board warms up over minutes; a run that must not go on ends this soon.
const PERIOD: Duration = Duration::from_millis(200);

/// Reads the sensor. Without one, or with one that was never calibrated, the
/// instrument works on and says that it does not know its temperature.
#[embassy_executor::task]
pub(crate) async fn thermometer(mut converter: SensorConverter) -> ! {
    let Some(thermometer) = Thermometer::new(factory_codes()) else {
        defmt::warn!("the temperature sensor has no calibration");
        stand_still().await
    };
    if converter.start().await.is_err() {
        defmt::warn!("the converter of the temperature sensor does not answer");
        stand_still().await
    }
    let mut ticker = Ticker::every(PERIOD);
    loop {
        let read = converter.read().await;
        let codes = read.inspect_err(|NotReady| defmt::warn!("temperature not read"));
        let codes = codes.ok();
        state::SUPPLY_V.set(codes.and_then(|codes| thermometer.supply_v(codes.reference)));
        let temperature_c =
            codes.and_then(|codes| thermometer.temperature_c(codes.sensor, codes.reference));
        state::TEMPERATURE_C.set(temperature_c);
        if temperature_c.is_some_and(|value| !may_work_at(value))
            && state::status().state.is_exciting()
        {
            defmt::error!("{} degrees Celsius: out of range", temperature_c);
            let order = Order::Stop(Reason::TemperatureOutOfRange);
            state::ORDERS.send(order).await;
        }
        ticker.next().await;
    }
}

async fn stand_still() -> ! {
    loop {
        Timer::after(Duration::MAX).await;
    }
}

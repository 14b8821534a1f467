package lightning.scene.sky;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SunPositionTest {
    /** Example of Reda and Andreas, Solar position algorithm for solar radiation applications, NREL 2003: zenith 50.11162, azimuth 194.34024 degrees. */
    @Test
    void position_isThatOfTheReferenceAlgorithm() {
        SunPosition sun = SunPosition.at(39.742476, -105.1786, Instant.parse("2003-10-17T19:30:30Z"));
        // The example's angle includes refraction, a minute of arc at this height.
        assertThat(sun.elevation()).isCloseTo(90 - 50.11162, within(0.03));
        assertThat(sun.azimuth()).isCloseTo(194.34024, within(0.01));
    }

    /** At an equinox, the sun of the equator is overhead at its noon, which the equation of time moves by 7.5 minutes: 12:07:30. */
    @Test
    void equatorAtEquinox_hasTheSunOverhead() {
        assertThat(SunPosition.at(0, 0, Instant.parse("2024-03-20T12:07:30Z")).elevation()).isCloseTo(90, within(0.3));
    }

    /** At a solstice the highest sun is 90 − latitude ± 23.44 degrees; it is in the south of the north and the north of the south. */
    @ParameterizedTest
    @CsvSource({"2024-06-20T12:01:45Z, 52, 61.44, 180", "2024-12-21T11:58:10Z, 52, 14.56, 180", "2024-12-21T11:58:10Z, -52, 61.44, 0"})
    void noonAtSolstice_hasTheKnownHeight(Instant time, double latitude, double elevation, double azimuth) {
        SunPosition sun = SunPosition.at(latitude, 0, time);
        assertThat(sun.elevation()).isCloseTo(elevation, within(0.05));
        assertThat((sun.azimuth() + 90) % 360).isCloseTo(azimuth + 90, within(0.5));
    }

    @Test
    void morningSun_isInTheEast() {
        assertThat(SunPosition.at(50, 15, Instant.parse("2026-11-27T07:00:00Z")).azimuth()).isBetween(90.0, 180.0);
    }

    @Test
    void placeBeyondTheGlobe_isRefused() {
        assertThatThrownBy(() -> SunPosition.at(91, 0, Instant.EPOCH)).hasMessage("latitude must be from -90 to 90, was 91");
    }
}

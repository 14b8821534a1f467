package lightning.scene.sky;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import lightning.scene.value.SceneLimits;

/**
 * Position of the sun in the sky of a place, without refraction: the algorithm of Blanco-Muriel and others, Computing the solar vector, Solar Energy
 * 70 (2001). Its authors give an error of half a minute of arc for the years 1999 to 2015; it grows slowly before and after.
 *
 * @param elevation degrees above the horizon, −90 … 90
 * @param azimuth   degrees from north toward east, 0 … 360
 */
public record SunPosition(double elevation, double azimuth) {
    private static final Instant EPOCH = Instant.parse("2000-01-01T12:00:00Z");
    private static final double EARTH_RADIUS_KM = 6371.01;
    private static final double ASTRONOMICAL_UNIT_KM = 149_597_890;

    /**
     * Returns the position at a time.
     *
     * @param latitude  degrees, north positive, −90 … 90
     * @param longitude degrees, east positive, −180 … 180
     * @throws IllegalArgumentException if a number is out of range
     */
    public static SunPosition at(double latitude, double longitude, Instant time) {
        SceneLimits.checkRange("latitude", latitude, -90, 90);
        SceneLimits.checkRange("longitude", longitude, -180, 180);
        double days = Duration.between(EPOCH, time).toMillis() / 86_400_000.0;
        double hour = time.atOffset(ZoneOffset.UTC).toLocalTime().toNanoOfDay() / 3.6e12;
        double omega = 2.1429 - 0.0010394594 * days;
        double meanLongitude = 4.8950630 + 0.017202791698 * days;
        double anomaly = 6.2400600 + 0.0172019699 * days;
        double ecliptic = meanLongitude + 0.03341607 * StrictMath.sin(anomaly) + 0.00034894 * StrictMath.sin(2 * anomaly) - 0.0001134
                - 0.0000203 * StrictMath.sin(omega);
        double obliquity = 0.4090928 - 6.2140e-9 * days + 0.0000396 * StrictMath.cos(omega);
        double ascension = StrictMath.atan2(StrictMath.cos(obliquity) * StrictMath.sin(ecliptic), StrictMath.cos(ecliptic));
        double declination = StrictMath.asin(StrictMath.sin(obliquity) * StrictMath.sin(ecliptic));
        double siderealHours = 6.6974243242 + 0.0657098283 * days + hour;
        double hourAngle = StrictMath.toRadians(siderealHours * 15 + longitude) - ascension;
        double phi = StrictMath.toRadians(latitude);
        double cosine = StrictMath.cos(phi) * StrictMath.cos(hourAngle) * StrictMath.cos(declination)
                + StrictMath.sin(declination) * StrictMath.sin(phi);
        double zenith = StrictMath.acos(Math.clamp(cosine, -1, 1));
        double azimuth = StrictMath.toDegrees(StrictMath.atan2(-StrictMath.sin(hourAngle),
                StrictMath.tan(declination) * StrictMath.cos(phi) - StrictMath.sin(phi) * StrictMath.cos(hourAngle)));
        double parallax = EARTH_RADIUS_KM / ASTRONOMICAL_UNIT_KM * StrictMath.sin(zenith);
        return new SunPosition(90 - StrictMath.toDegrees(zenith + parallax), azimuth < 0 ? azimuth + 360 : azimuth);
    }
}

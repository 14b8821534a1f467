package lightning.format.exchange;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import lightning.base.math.Vec3;
import lightning.format.exchange.assembly.ImportSubject;
import lightning.scene.Camera;

/**
 * Directions and unit of length for the lights around a subject: right, up and toward the camera. The unit is that of a studio whose subject
 * has a radius of {@value #RADIUS}.
 */
final class SubjectFrame {
    private static final double RADIUS = 1.6;
    /** Direction from the subject to a camera that is placed here. */
    private static final Vec3 TO_CAMERA = new Vec3(0.45, 0.2, 0.9);
    private static final double FOV = 29;
    /** Space around the subject, as a factor of its size. */
    private static final double MARGIN = 1.2;
    private static final int DIGITS = 4;

    private final ImportSubject subject;
    private final Vec3 back;
    private final Vec3 right;

    SubjectFrame(ImportSubject subject, Camera camera) {
        this.subject = subject;
        Vec3 view = camera.from().minus(camera.to());
        Vec3 level = new Vec3(view.x(), 0, view.z());
        // A camera that looks straight down has no horizontal direction.
        back = level.length() > 1e-6 * view.length() ? level.normalized() : new Vec3(0, 0, 1);
        right = Vec3.Y.cross(back);
    }

    /** Returns a camera whose picture the subject fills. */
    static Camera camera(ImportSubject subject, double aspectRatio) {
        Vec3 toward = TO_CAMERA.normalized();
        Vec3 right = Vec3.Y.cross(toward).normalized();
        Vec3 up = toward.cross(right);
        double tangent = Math.tan(Math.toRadians(FOV / 2)) / MARGIN;
        double distance = subject.corners().map(corner -> corner.minus(subject.center()))
                .mapToDouble(p -> p.dot(toward) + Math.max(Math.abs(p.dot(up)), Math.abs(p.dot(right)) / aspectRatio) / tangent)
                .max().orElseThrow();
        Vec3 to = round(subject.center(), subject.radius());
        double nearest = 1.05 * subject.radius();
        return new Camera(round(to.plus(toward.times(Math.max(distance, nearest))), subject.radius()), to, Vec3.Y, FOV);
    }

    /** Returns scene units per unit of the studio. */
    double unit() {
        return round(subject.radius() / RADIUS);
    }

    /** Returns a length, scene units. */
    double length(double units) {
        return round(units * unit());
    }

    /** Returns a quadratic attenuation, per square scene unit. */
    double quadratic(double perSquareUnit) {
        return round(perSquareUnit / (unit() * unit()));
    }

    /** Returns a position relative to the subject's center. */
    Vec3 position(double x, double y, double z) {
        return round(subject.center().plus(offset(x, y, z).times(unit())), subject.radius());
    }

    /** Returns a readable position near another. */
    Vec3 rounded(Vec3 position) {
        return round(position, subject.radius());
    }

    /** Returns a readable length near another. */
    double rounded(double length) {
        return round(length);
    }

    /** Returns a direction: x to the right, y up, z toward the camera. */
    Vec3 direction(double x, double y, double z) {
        return round(offset(x, y, z), 1);
    }

    private Vec3 offset(double x, double y, double z) {
        return right.times(x).plus(Vec3.Y.times(y)).plus(back.times(z));
    }

    /** Returns the point below the subject's center on which it stands. */
    Vec3 foot() {
        return round(new Vec3(subject.center().x(), subject.min().y(), subject.center().z()), subject.radius() / 1000);
    }

    /** Returns the rotation about y, degrees, that turns z toward the camera. */
    double rotation() {
        return round(Math.toDegrees(Math.atan2(back.x(), back.z())));
    }

    /** Rounds to a thousandth of a size, for readable numbers. */
    private static Vec3 round(Vec3 v, double size) {
        int decimals = 3 - (int) Math.floor(Math.log10(size));
        return new Vec3(round(v.x(), decimals), round(v.y(), decimals), round(v.z(), decimals));
    }

    private static double round(double v, int decimals) {
        return BigDecimal.valueOf(v).setScale(decimals, RoundingMode.HALF_EVEN).doubleValue();
    }

    private static double round(double v) {
        return BigDecimal.valueOf(v).round(new MathContext(DIGITS)).doubleValue();
    }
}

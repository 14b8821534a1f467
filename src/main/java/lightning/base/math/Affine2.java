package lightning.base.math;

import java.util.Optional;

/** Affine map of a plane: u′ = uu · u + uv · v + u0, v′ = vu · u + vv · v + v0. */
public record Affine2(double uu, double uv, double u0, double vu, double vv, double v0) {
    /** Leaves every point at its place. */
    public static final Affine2 IDENTITY = new Affine2(1, 0, 0, 0, 1, 0);
    /** Turns v upside down: 1 − v. */
    public static final Affine2 FLIP = new Affine2(1, 0, 0, 0, -1, 1);

    /** Returns u′. */
    public double u(double u, double v) {
        return uu * u + uv * v + u0;
    }

    /** Returns v′. */
    public double v(double u, double v) {
        return vu * u + vv * v + v0;
    }

    /** Returns the map that applies {@code first}, then this one. */
    public Affine2 times(Affine2 first) {
        return new Affine2(uu * first.uu + uv * first.vu, uu * first.uv + uv * first.vv, u(first.u0, first.v0),
                vu * first.uu + vv * first.vu, vu * first.uv + vv * first.vv, v(first.u0, first.v0));
    }

    /** Returns the map back; empty if this one maps the plane to a line or a point. */
    public Optional<Affine2> inverse() {
        double determinant = uu * vv - uv * vu;
        if (determinant == 0 || !Double.isFinite(1 / determinant)) {
            return Optional.empty();
        }
        var turn = new Affine2(vv / determinant, -uv / determinant, 0, -vu / determinant, uu / determinant, 0);
        return Optional.of(new Affine2(turn.uu, turn.uv, -turn.u(u0, v0), turn.vu, turn.vv, -turn.v(u0, v0)));
    }
}

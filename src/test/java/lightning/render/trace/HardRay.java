package lightning.render.trace;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.scene.node.Solid;

/** Ray configurations that are known to be numerically difficult, in local space of a canonical solid. */
enum HardRay {
    /** From anywhere, up to 10⁸ away, to any point near the solid. */
    FROM_AFAR {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            return aimedRay(pointInBox(solid, random), direction(random), distance(random));
        }
    },
    /** Across the silhouette, at decreasing distances. */
    TANGENT {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            Vec3 p = pointOnSurface(solid, random);
            Vec3 n = normal(solid, p);
            Vec3 along = n.cross(direction(random)).normalized();
            double beside = random.nextInt(4) == 0 ? 0 : sign(random) * Math.scalb(random.nextDouble(), -random.nextInt(56));
            return aimedRay(p.plus(n.times(beside)), along, random.nextInt(4) == 0 ? 0 : distance(random));
        }
    },
    /** Along the axes, with zeros of both signs. */
    ALONG_AN_AXIS {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            double[] d = {random.nextBoolean() ? 0.0 : -0.0, random.nextBoolean() ? 0.0 : -0.0, random.nextBoolean() ? 0.0 : -0.0};
            d[random.nextInt(3)] = sign(random);
            Vec3 to = random.nextBoolean() ? pointInBox(solid, random) : pointOnSurface(solid, random);
            return aimedRay(to, new Vec3(d[0], d[1], d[2]), distance(random));
        }
    },
    /** Almost along the axis, inside and outside. */
    ALMOST_PARALLEL {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            double tilt = Math.scalb(1.0, -random.nextInt(120));
            Vec3 d = new Vec3(tilt * (random.nextDouble() - 0.5), sign(random), tilt * (random.nextDouble() - 0.5));
            double r = random.nextInt(3) == 0 ? 1 + sign(random) * Math.scalb(random.nextDouble(), -random.nextInt(56))
                    : 1.2 * random.nextDouble();
            return aimedRay(pointOnCircle(random).times(r).plus(new Vec3(0, random.nextDouble(), 0)), d, distance(random));
        }
    },
    /** Through the apex or near it. */
    THROUGH_THE_APEX {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            double past = random.nextInt(3) == 0 ? 0 : Math.scalb(1.0, -random.nextInt(60));
            return aimedRay(Vec3.Y.plus(direction(random).times(past)), direction(random), distance(random));
        }
    },
    /** Along a generator of the side, on it, next to it, and tilted against it. */
    ALONG_A_GENERATOR {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            Vec3 foot = random.nextBoolean() ? new Vec3(0, 0, sign(random)) : pointOnCircle(random);
            Vec3 d = pointOnTop(solid, foot).minus(foot);
            double tilt = random.nextInt(3) == 0 ? 0 : Math.scalb(1.0, -random.nextInt(60));
            double beside = random.nextInt(3) == 0 ? 0 : Math.scalb(1.0, -random.nextInt(60));
            Vec3 p = foot.plus(d.times(random.nextDouble())).plus(direction(random).times(beside));
            return aimedRay(p, d.times(sign(random)).plus(direction(random).times(tilt)), distance(random));
        }
    },
    /** Near the edge between cap and side. */
    NEAR_A_RIM {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            double past = random.nextInt(4) == 0 ? 0 : Math.scalb(1.0, -random.nextInt(60));
            Vec3 foot = pointOnCircle(random);
            Vec3 p = (random.nextBoolean() ? foot : pointOnRim(solid, foot)).plus(direction(random).times(past));
            return aimedRay(p, direction(random), distance(random));
        }
    },
    /** In the plane of a cap, or of the square, and almost. */
    IN_THE_PLANE {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            double tilt = random.nextBoolean() ? 0 : Math.scalb(1.0, -random.nextInt(120));
            double above = random.nextBoolean() ? 0 : sign(random) * Math.scalb(1.0, -random.nextInt(60));
            Vec3 d = pointOnCircle(random).plus(new Vec3(0, tilt * sign(random), 0));
            return aimedRay(new Vec3(1.2 * random.nextDouble(), random.nextInt(2) + above, 1.2 * random.nextDouble()), d, distance(random));
        }
    },
    /** From the surface itself, in all directions. */
    FROM_THE_SURFACE {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            return new Ray(pointOnSurface(solid, random), direction(random));
        }
    },
    /** From inside. */
    FROM_WITHIN {
        @Override
        Ray create(Solid.Canonical solid, Random random) {
            return new Ray(pointOnSurface(solid, random).times(0.999 * random.nextDouble()), direction(random));
        }
    };

    /** Returns a ray with a direction of length 1. */
    abstract Ray create(Solid.Canonical solid, Random random);

    /** Returns a ray with a direction of any length that tracers support. */
    Ray unnormalized(Solid.Canonical solid, Random random) {
        Ray ray = create(solid, random);
        return new Ray(ray.origin(), ray.direction().times(Math.pow(10, 60 * random.nextDouble() - 30)));
    }

    /** Returns the upper end of the side's generator from a point of the base's rim. */
    private static Vec3 pointOnTop(Solid.Canonical solid, Vec3 foot) {
        return switch (solid) {
            case Solid.Sphere _,Solid.Plane _,Solid.Cone _,Solid.Cylinder _ -> Vec3.Y;
            case Solid.Frustum f -> foot.times(f.top()).plus(Vec3.Y);
        };
    }

    /** Returns the point of the upper rim above one of the base's rim. */
    private static Vec3 pointOnRim(Solid.Canonical solid, Vec3 foot) {
        return switch (solid) {
            case Solid.Sphere _,Solid.Plane _,Solid.Cone _,Solid.Cylinder _ -> foot.plus(Vec3.Y);
            case Solid.Frustum f -> foot.times(f.top()).plus(Vec3.Y);
        };
    }

    static Vec3 pointOnSurface(Solid.Canonical solid, Random random) {
        Vec3 ring = pointOnCircle(random);
        double h = random.nextDouble();
        double r = Math.sqrt(random.nextDouble());
        return switch (solid) {
            case Solid.Sphere _ -> direction(random).normalized();
            case Solid.Cone c -> c.caps() && random.nextInt(3) == 0 ? ring.times(r) : new Vec3(ring.x() * (1 - h), h, ring.z() * (1 - h));
            case Solid.Cylinder c -> c.caps() && random.nextInt(3) == 0 ? ring.times(r).plus(new Vec3(0, random.nextInt(2), 0))
                    : new Vec3(ring.x(), h, ring.z());
            case Solid.Frustum f -> {
                if (f.caps() && random.nextInt(3) == 0) {
                    yield random.nextBoolean() ? ring.times(r) : ring.times(r * f.top()).plus(Vec3.Y);
                }
                yield ring.times(1 - (1 - f.top()) * h).plus(new Vec3(0, h, 0));
            }
            case Solid.Plane _ -> new Vec3(random.nextDouble() - 0.5, 0, random.nextDouble() - 0.5);
        };
    }

    private static Vec3 normal(Solid.Canonical solid, Vec3 p) {
        Vec3 out = new Vec3(p.x(), 0, p.z());
        return switch (solid) {
            case Solid.Sphere _ -> p;
            case Solid.Cone _ -> out.maxAbs() == 0 || p.y() == 0 ? Vec3.Y : out.normalized().plus(Vec3.Y).normalized();
            case Solid.Cylinder _,Solid.Plane _ -> out.maxAbs() == 0 || p.y() == 0 || p.y() == 1 ? Vec3.Y : out.normalized();
            case Solid.Frustum f -> out.maxAbs() == 0 || p.y() == 0 || p.y() == 1 ? Vec3.Y
                    : out.normalized().plus(new Vec3(0, 1 - f.top(), 0)).normalized();
        };
    }

    private static Ray aimedRay(Vec3 to, Vec3 direction, double distance) {
        Vec3 d = direction.normalized();
        return new Ray(to.minus(d.times(distance)), d);
    }

    private static Vec3 pointInBox(Solid.Canonical solid, Random random) {
        double wide = Math.max(1, CanonicalSolids.topRadius(solid));
        return new Vec3(wide * (2.4 * random.nextDouble() - 1.2), 2.4 * random.nextDouble() - 1.2,
                wide * (2.4 * random.nextDouble() - 1.2));
    }

    static Vec3 direction(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }

    private static Vec3 pointOnCircle(Random random) {
        double angle = 2 * Math.PI * random.nextDouble();
        return new Vec3(Math.cos(angle), 0, Math.sin(angle));
    }

    private static double distance(Random random) {
        return Math.pow(10, 10 * random.nextDouble() - 2);
    }

    private static double sign(Random random) {
        return random.nextBoolean() ? 1 : -1;
    }
}

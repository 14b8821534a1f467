package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.cell.TangentColumns;
import lightning.render.lobe.CoatShare;
import lightning.render.lobe.ReflectionLobe;
import lightning.render.lobe.RoughLobes;
import lightning.render.lobe.RoughLobes.Kind;
import lightning.render.lobe.SheenDirections;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Lobes of a reflection point: directions in which it is seen to reflect, with their weights and densities. Holds the present point and direction: use
 * one instance per thread.
 */
final class PointLobes {
    private static final double MIN_COSINE = 1e-3;
    /** Width of the lobe that enters a body, which stands for both of its surfaces: variances add up. */
    private static final double TWO_SURFACES = Math.sqrt(2);

    private final int side;
    private final ReflectionLobe lobe = new ReflectionLobe();
    private final SheenDirections sheen = new SheenDirections();
    /** Lobes of the present point's material. */
    private @Nullable RoughLobes its;
    private double roughness;
    /** Cosine between the view of the point and its normal, the share of its coat, and the rays of its rarest lobe. */
    private double cosine;
    private double coat;
    private int fewestRays;
    /** Frame of the point: the plane of normal and view, and the normal. */
    private final double[] tangent = new double[3];
    private final double[] bitangent = new double[3];
    private final double[] normal = new double[3];
    /** Direction of an anisotropic material in this frame. */
    private double turnX;
    private double turnY;
    /** Present direction, of length 1. */
    final double[] d = new double[3];
    /** Weights of the direction: what the reflectance multiplies, and what no color multiplies. */
    double color;
    double white;
    /** Density of the direction in its lobe, per steradian; 0 if it is unknown. */
    double density;

    /** @param side rays along each side of the grid of a point's rays */
    PointLobes(int side) {
        this.side = side;
    }

    /** Moves to a point: its view lies in the plane of the tangent and the normal. @param material lobes of its material */
    void moveTo(ReflectionPoints points, int p, RoughLobes material) {
        its = material;
        roughness = points.seen.roughness[p];
        SurfaceColumns s = points.surface();
        double nx = s.nx[p];
        double ny = s.ny[p];
        double nz = s.nz[p];
        double view = -(points.seen.vx[p] * nx + points.seen.vy[p] * ny + points.seen.vz[p] * nz);
        cosine = Math.clamp(view, MIN_COSINE, 1);
        coat = its.coat() == null ? 0 : CoatShare.of(its.coat(), (float) cosine);
        fewestRays = its.fewestRays(side);
        double x = -points.seen.vx[p] - view * nx;
        double y = -points.seen.vy[p] - view * ny;
        double z = -points.seen.vz[p] - view * nz;
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 1e-6)) {
            // Any direction along the surface: the axis that is farthest from the normal.
            boolean isFlat = Math.abs(nx) < 0.6;
            x = isFlat ? 1 - nx * nx : -ny * nx;
            y = isFlat ? -nx * ny : 1 - ny * ny;
            z = isFlat ? -nx * nz : -ny * nz;
            length = Math.sqrt(x * x + y * y + z * z);
        }
        normal[0] = nx;
        normal[1] = ny;
        normal[2] = nz;
        tangent[0] = x / length;
        tangent[1] = y / length;
        tangent[2] = z / length;
        bitangent[0] = ny * tangent[2] - nz * tangent[1];
        bitangent[1] = nz * tangent[0] - nx * tangent[2];
        bitangent[2] = nx * tangent[1] - ny * tangent[0];
        if (its.anisotropy() != null) {
            turnTo(points, p, its.anisotropy());
        }
    }

    private void turnTo(ReflectionPoints points, int p, Anisotropy anisotropy) {
        TangentColumns t = points.seen.tangents;
        double x = t.x(p) * tangent[0] + t.y(p) * tangent[1] + t.z(p) * tangent[2];
        double y = t.x(p) * bitangent[0] + t.y(p) * bitangent[1] + t.z(p) * bitangent[2];
        double angle = Math.toRadians(anisotropy.rotation());
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double length = Math.sqrt(x * x + y * y);
        turnX = (cos * x - sin * y) / length;
        turnY = (sin * x + cos * y) / length;
    }

    private RoughLobes its() {
        return requireNonNull(its);
    }

    /** Returns the lobe of ray {@code k} of the point. */
    Kind kind(int k) {
        return its().kind(k / side, k % side);
    }

    /** Returns the number of rays of a lobe. */
    int rays(Kind kind) {
        return its().rays(kind, side);
    }

    private double alpha(Kind kind) {
        return alpha(its(), kind, roughness);
    }

    /** Returns the width α of a lobe at a point; 0 if it is smooth. @param roughness of the surface there, with its map */
    static double alpha(RoughLobes its, Kind kind, double roughness) {
        if (kind == Kind.SHEEN) {
            return RoughLobes.SHEEN_ALPHA;
        }
        double alpha = kind == Kind.COAT ? its.coatAlpha() : its.alpha() == 0 ? 0 : Material.alpha(roughness);
        return kind == Kind.PASSING && requireNonNull(its.frost()).ior() != 1 ? Math.min(1, TWO_SURFACES * alpha) : alpha;
    }

    /** Aims at the lobe of a kind. @param alpha its width α */
    private void aim(Kind kind, double alpha) {
        Anisotropy anisotropy = its().anisotropy();
        if (anisotropy == null || kind != Kind.SURFACE) {
            lobe.aim(cosine, alpha);
        } else {
            lobe.aim(cosine, anisotropy.along(alpha), anisotropy.across(alpha), turnX, turnY);
        }
    }

    /**
     * Chooses a direction of a lobe.
     *
     * @param share first coordinate of a place in the unit square, 0…1
     * @param cos   of the angle that is the second, with {@code sin}
     */
    void scatter(Kind kind, double share, double cos, double sin) {
        color = 0;
        white = 0;
        density = 0;
        double factor = (double) fewestRays / rays(kind);
        if (kind == Kind.SHEEN) {
            sheen.aim(requireNonNull(its().fibers()).roughness(), cosine);
            sheen.scatter(share, cos, sin);
            direct(sheen.x(), sheen.y(), sheen.z());
            density = sheen.density();
            white = factor;
            return;
        }
        aim(kind, alpha(kind));
        lobe.reflect(share, cos, sin);
        if (kind == Kind.PASSING) {
            lobe.pass(requireNonNull(its().frost()).ior());
            direct(lobe.x(), lobe.y(), Math.min(lobe.z(), -lobe.z()));
        } else {
            direct(lobe.x(), lobe.y(), Math.abs(lobe.z()));
            density = lobe.density();
        }
        addWeights(kind, factor);
    }

    /** Sets the direction to one in the frame of the point. */
    private void direct(double x, double y, double z) {
        for (int i = 0; i < 3; i++) {
            d[i] = x * tangent[i] + y * bitangent[i] + z * normal[i];
        }
    }

    /**
     * Weighs the direction as one that was chosen otherwise, once in a solid angle, beside the rays of all lobes (balance heuristic).
     *
     * @param angle steradians; 0 for no weight
     */
    void weigh(double angle) {
        color = 0;
        white = 0;
        density = 0;
        double z = dot(normal);
        if (angle > 0 && z > 0) {
            double x = dot(tangent);
            double y = dot(bitangent);
            addAimed(Kind.SURFACE, alpha(Kind.SURFACE), x, y, z, angle);
            addAimed(Kind.COAT, its().coatAlpha(), x, y, z, angle);
            if (its().fibers() != null) {
                sheen.aim(its().fibers().roughness(), cosine);
                sheen.moveTo(x, y, z);
                double own = sheen.density() * angle;
                white += fewestRays * own / (rays(Kind.SHEEN) * own + 1);
            }
        }
    }

    private double dot(double[] axis) {
        return d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
    }

    /** Adds the weights of the direction for one lobe, relative to those of the rays of the lobe that has the fewest. */
    private void addAimed(Kind kind, double alpha, double x, double y, double z, double angle) {
        if (alpha > 0) {
            aim(kind, alpha);
            lobe.moveTo(x, y, z);
            double own = lobe.density() * angle;
            addWeights(kind, fewestRays * own / (rays(kind) * own + 1));
        }
    }

    /**
     * Adds the weights of a direction of a lobe. Below a sheen, all have one weight. A frosted surface has one for reflected light, and one for
     * light that passes it.
     */
    private void addWeights(Kind kind, double factor) {
        double share = factor * lobe.weight();
        RoughLobes lobes = its();
        if (lobes.frost() != null) {
            double fresnel = lobes.frost().f0() + (1 - lobes.frost().f0()) * lobe.schlick();
            color += kind == Kind.PASSING ? 0 : share * fresnel;
            white += kind == Kind.PASSING ? share * (1 - fresnel) : 0;
        } else if (kind == Kind.COAT) {
            double f0 = requireNonNull(lobes.coat()).f0();
            double coated = share * lobes.coat().weight() * (f0 + (1 - f0) * lobe.schlick());
            color += lobes.fibers() == null ? 0 : coated;
            white += lobes.fibers() == null ? coated : 0;
        } else if (lobes.fibers() != null) {
            double f0 = lobes.fibers().f0();
            color += share * (1 - coat) * (f0 + (1 - f0) * lobe.schlick());
        } else {
            color += share * (1 - coat) * (1 - lobe.schlick());
            white += share * (1 - coat) * lobe.schlick();
        }
    }
}

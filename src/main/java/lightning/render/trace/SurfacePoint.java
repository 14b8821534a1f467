package lightning.render.trace;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.scene.Transmission;

/**
 * One hit row on its own: what a ray met, as shading sees it.
 *
 * @param primitive index of the primitive
 * @param material index of its material
 * @param px       the point, off the surface, render space; likewise {@code py}, {@code pz}
 * @param nx       the unit normal that faces the ray; likewise {@code ny}, {@code nz}
 * @param vx       the unit direction of the ray; likewise {@code vy}, {@code vz}
 * @param diffuse  k<sub>diffuse</sub> with the texture in it, linear RGB, {@code float[3]}
 * @param specular k<sub>specular</sub>, or F0 with the texture in it, linear RGB, {@code float[3]}
 * @param backSide   where rays go on behind the surface; null where nothing is seen through it
 * @param texel    the texture's color alone, linear RGB, {@code float[3]}; white where there is none
 */
public record SurfacePoint(int primitive, int material, float px, float py, float pz, float nx, float ny, float nz,
        float vx, float vy, float vz, float[] diffuse, float[] specular, float[] texel, BackSide backSide) {

    /**
     * Where rays go on behind a surface.
     *
     * @param transmission of its material
     * @param x       the point, off the surface, render space; likewise {@code y}, {@code z}
     * @param insideDistance  the way that the ray came inside, scene units; below 0 where it came from outside
     */
    public record BackSide(Transmission transmission, float x, float y, float z, float insideDistance) {
        public boolean isInside() {
            return insideDistance >= 0;
        }
    }

    /** The refracted ray; null where the surface mirrors all. */
    public Ray refractedRay() {
        double[] d = new double[3];
        boolean passes = Refraction.writeDirection(nx, ny, nz, vx, vy, vz, Refraction.eta(backSide.transmission(), backSide.isInside()), d);
        return passes ? new Ray(new Vec3(backSide.x(), backSide.y(), backSide.z()), new Vec3(d[0], d[1], d[2])) : null;
    }

    /** Which part of the light a clear surface mirrors. */
    public float reflectance() {
        return Refraction.fresnelReflectance(backSide.transmission(), backSide.isInside(), nx, ny, nz, vx, vy, vz);
    }

    /** The mirrored ray, V + 2|N·V|N at length 1: away from the surface whatever the rounding. */
    public Ray reflectedRay() {
        double[] d = new double[3];
        writeReflection(nx, ny, nz, vx, vy, vz, d);
        return new Ray(new Vec3(px, py, pz), new Vec3(d[0], d[1], d[2]));
    }

    /**
     * Writes the direction of the mirrored ray.
     *
     * @param to gets x, y, z, {@code double[3]}
     */
    public static void writeReflection(float nx, float ny, float nz, float vx, float vy, float vz, double[] to) {
        double twice = 2 * Math.abs((double) nx * vx + (double) ny * vy + (double) nz * vz);
        double rx = vx + twice * nx;
        double ry = vy + twice * ny;
        double rz = vz + twice * nz;
        double length = Math.sqrt(rx * rx + ry * ry + rz * rz);
        to[0] = rx / length;
        to[1] = ry / length;
        to[2] = rz / length;
    }
}

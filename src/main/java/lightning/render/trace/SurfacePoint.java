package lightning.render.trace;

import java.util.Map;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Single hit with the data for shading: one row of {@link HitRows} as a record.
 *
 * @param primitive index of the primitive
 * @param material index of its material
 * @param px point, offset from the surface, render space; also {@code py}, {@code pz}
 * @param nx unit normal, facing the ray; also {@code ny}, {@code nz}
 * @param vx unit direction of the ray; also {@code vy}, {@code vz}
 * @param diffuse k<sub>diffuse</sub> including the texture, linear RGB, {@code float[3]}
 * @param specular k<sub>specular</sub>, or F0 including the texture, linear RGB, {@code float[3]}
 * @param roughness of a metallic material, including its map
 * @param backSide start of a ray that passes; null for opaque materials
 * @param texel texture color alone, linear RGB, {@code float[3]}; white if there is none
 * @param maps colors of the material's other images, linear RGB, {@code float[3]} each, or {@code float[1]} of a map that reads one channel; none
 *     for images that it lacks; and the tangent of an anisotropic material, {@code float[3]}
 */
public record SurfacePoint(int primitive, int material, float px, float py, float pz, float nx, float ny, float nz,
        float vx, float vy, float vz, float[] diffuse, float[] specular, double roughness, float[] texel, Map<ColumnGroup, float[]> maps,
        @Nullable BackSide backSide) {

    /**
     * Start of a ray behind a transparent surface.
     *
     * @param transmission transmission of the material
     * @param x point, offset from the surface, render space; also {@code y}, {@code z}
     * @param insideDistance length of the ray inside the body, scene units; below 0 if it came from outside
     * @param frosted whether the surface blurs what is behind it, so that it refracts no single ray
     */
    public record BackSide(Transmission transmission, float x, float y, float z, float insideDistance, boolean frosted) {
        public boolean isInside() {
            return insideDistance >= 0;
        }
    }

    /** Returns the unit tangent of an anisotropic material, {@code float[3]}; 0 for others. */
    public float[] tangent() {
        return maps.getOrDefault(ColumnGroup.TANGENT, new float[3]);
    }

    /** Returns the numbers of its material here, which is principled and not clear. */
    public MappedSurface mapped(Material m) {
        var mapped = new MappedSurface();
        mapped.moveTo(m, maps);
        return mapped;
    }

    /** Returns the back side of a clear material; null for others. */
    public @Nullable BackSide clearSide() {
        return backSide == null || backSide.frosted ? null : backSide;
    }

    /** Returns whether the refracted ray of a clear material is outside of its body: the material is a thin sheet, or the ray leaves the body. */
    public boolean isInAirBehind() {
        BackSide side = clearSide();
        return side != null && (side.isInside() || side.transmission().thin());
    }

    /** Returns the refracted ray of a clear material; null if reflection is total. */
    public @Nullable Ray refractedRay() {
        assert backSide != null;
        double[] d = new double[3];
        boolean passes = Refraction.writeDirection(nx, ny, nz, vx, vy, vz, Refraction.eta(backSide.transmission(), backSide.isInside()), d);
        return passes ? new Ray(new Vec3(backSide.x(), backSide.y(), backSide.z()), new Vec3(d[0], d[1], d[2])) : null;
    }

    /** Returns the reflected fraction of the light at a transparent surface. */
    public float reflectance() {
        assert backSide != null;
        return Refraction.fresnelReflectance(backSide.transmission(), backSide.isInside(), nx, ny, nz, vx, vy, vz);
    }

    /** Returns the unit normal of its coat: that of the surface unless it has its own. */
    public float[] coatNormal() {
        float[] own = maps.get(ColumnGroup.COAT_NORMAL);
        return own == null ? new float[] {nx, ny, nz} : own;
    }

    /** Returns the ray that its material mirrors: along the normal of its coat, if that mirrors by other normals. */
    public Ray reflectedRay(Material m) {
        float[] coat = maps.get(ColumnGroup.COAT_NORMAL);
        return coat == null || !m.coatNormals().mirrors() ? reflectedRay() : reflectedRay(coat[0], coat[1], coat[2]);
    }

    /** Returns the reflected ray with direction V + 2|N·V|N, normalized. It leaves the surface whatever the rounding. */
    public Ray reflectedRay() {
        return reflectedRay(nx, ny, nz);
    }

    private Ray reflectedRay(float normalX, float normalY, float normalZ) {
        double[] d = new double[3];
        writeReflection(normalX, normalY, normalZ, vx, vy, vz, d);
        return new Ray(new Vec3(px, py, pz), new Vec3(d[0], d[1], d[2]));
    }

    /**
     * Writes the direction of the reflected ray.
     *
     * @param to receives x, y, z, {@code double[3]}
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

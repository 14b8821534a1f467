package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.Objects;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.CandidateList;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Up to 1024 rays with any origins and directions, which pass through transparent surfaces and faces of lights. Holds scratch memory:
 * use one per thread.
 *
 * <p>Rows of its hits are on their facets, not lifted by vertex normals: in narrow gaps a lifted point is behind the other surface.
 *
 * <p>A ray that hits a transparent surface continues in the same direction. It is tinted as a tinted shadow ray is: by the share of light
 * that the surface does not reflect, by its color, and by the path inside the body. Light that the surface reflects toward the ray is
 * lost. The face of a light does not change the ray, because the light itself is computed by shadow rays; but none passes a frosted body, so
 * a ray that entered one ends at such a face.
 */
public final class RayBatch {
    /** Maximum number of rays. */
    public static final int MAX_RAYS = RayColumns.MAX_RAYS;
    /** A ray that passes more surfaces than this meets nothing, not even the background: its tint is black. */
    public static final int MAX_SURFACES = 256;
    /** Surfaces at which a ray may meet a mirror. */
    private static final int MAX_MIRRORS = 4;
    /** Surfaces at which a ray inside a frosted body may be reflected totally. */
    private static final int MAX_INTERNAL = 8;

    /** Origins, render space. */
    public final float[] startX = new float[MAX_RAYS + 64];
    public final float[] startY = new float[MAX_RAYS + 64];
    public final float[] startZ = new float[MAX_RAYS + 64];
    /** Directions; of length 1 if the geometry has transparent surfaces. */
    public final double[] directionX;
    public final double[] directionY;
    public final double[] directionZ;
    /** For batches that follow rays: whether each ray starts in front of a frosted surface that it passes first, unbent and without tint. */
    public final boolean[] enters = new boolean[MAX_RAYS];
    /** Product of the tints of the surfaces that each ray passed: red, green, blue. Valid only if {@link #isTinted}. */
    public final float[][] tint = new float[3][MAX_RAYS];
    private final Geometry geometry;
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final Tracer tracer;
    private final HitRowBuilder rowBuilder;
    private final RayColumns rays;
    private final CandidateList candidates = new CandidateList();
    private final SurfaceHit surface = new SurfaceHit();
    /** Rays in an order in which neighbors have similar directions. */
    private final RayColumns sorted;
    private final DirectionOrder order = new DirectionOrder(MAX_RAYS);
    /** Rays to trace, first all, then those that pass a surface. */
    private final short[] selected = new short[MAX_RAYS];
    /** Length of each ray before its last segment. */
    private final double[] passed = new double[MAX_RAYS];
    private boolean tinted;
    private final boolean hasPassableSurfaces;
    /** Share that each material reflects in the mirrored direction; null if rays end there, as at all materials initially. */
    private final @Nullable Rgb[] mirrors;
    /** True for materials that bend rays; none unless the batch follows rays. */
    private final boolean[] bends;
    private final boolean[] isMirrored = new boolean[MAX_RAYS];
    /** Whether each ray entered a frosted body. */
    private final boolean[] hasEntered = new boolean[MAX_RAYS];
    private final double[] direction = new double[3];

    /** Creates a batch whose rays end at mirrors. */
    public RayBatch(Geometry geometry, Scene scene, Tracer tracer) {
        this(geometry, scene, tracer, false);
    }

    /**
     * @param followsRays whether rays go on in the mirrored direction at surfaces that reflect most light so ({@link Material#mirrorTint}),
     *                    and bent through frosted bodies
     */
    public RayBatch(Geometry geometry, Scene scene, Tracer tracer, boolean followsRays) {
        mirrors = new Rgb[geometry.materials().count()];
        bends = new boolean[mirrors.length];
        for (int m = 0; followsRays && m < mirrors.length; m++) {
            Material material = geometry.materials().material(m);
            mirrors[m] = material.mirrorTint();
            bends[m] = material.isFrosted() && !material.transmission().thin();
        }
        this.geometry = geometry;
        primitives = geometry.primitives();
        materials = geometry.materials();
        hasPassableSurfaces =
                materials.hasTransparent() || geometry.hasLightFaces() || Arrays.stream(mirrors).anyMatch(Objects::nonNull);
        this.tracer = tracer;
        rowBuilder = new HitRowBuilder(geometry, tracer);
        rays = new RayColumns(new CameraRays(scene.camera(), scene.picture()));
        sorted = new RayColumns(new CameraRays(scene.camera(), scene.picture()));
        rays.startsAtFacets = true;
        directionX = rays.dx;
        directionY = rays.dy;
        directionZ = rays.dz;
        // The rays go in all directions, so a beam would select all shapes.
        candidates.overflow = true;
    }

    /** Traces rays {@code 0 … count − 1}. Replaces the origins of rays that pass a transparent surface. */
    public void trace(int count) {
        traceToFirst(count);
        for (int pass = 1, moved = count; hasPassableSurfaces && moved > 0; pass++) {
            moved = moveThroughSurfaces(moved, pass);
            findNearest(moved);
        }
    }

    /** Traces rays {@code 0 … count − 1} to the first surface, which may be transparent. */
    public void traceToFirst(int count) {
        rays.startX = startX;
        rays.startY = startY;
        rays.startZ = startZ;
        rays.columns = 0;
        rays.count = count;
        for (int i = 0; i < count; i++) {
            rays.slot[i] = (short) i;
            passed[i] = 0;
            isMirrored[i] = false;
            hasEntered[i] = false;
        }
        tinted = false;
        System.arraycopy(rays.slot, 0, selected, 0, count);
        findNearest(count);
    }

    /** Traces the first {@code count} selected rays. */
    private void findNearest(int count) {
        if (geometry.primitiveCount() == 0) {
            Arrays.fill(rays.primitive, 0, rays.count, -1);
            return;
        }
        if (count == 0) {
            return;
        }
        order.sort(selected, count, rays, sorted.slot);
        sorted.startX = startX;
        sorted.startY = startY;
        sorted.startZ = startZ;
        sorted.count = count;
        for (int i = 0; i < count; i++) {
            int ray = sorted.slot[i];
            sorted.dx[i] = rays.dx[ray];
            sorted.dy[i] = rays.dy[ray];
            sorted.dz[i] = rays.dz[ray];
        }
        tracer.findNearest(sorted, candidates);
        for (int i = 0; i < count; i++) {
            int ray = sorted.slot[i];
            rays.t[ray] = sorted.t[i];
            rays.primitive[ray] = sorted.primitive[i];
            rays.part[ray] = sorted.part[i];
        }
    }

    /** Moves the origins of selected rays that pass a surface to its other side; selects these and returns their number. */
    private int moveThroughSurfaces(int count, int pass) {
        int moved = 0;
        for (int i = 0; i < count; i++) {
            int ray = selected[i];
            int primitive = rays.primitive[ray];
            if (primitive >= 0 && mirrors[primitives.material[primitive]] != null) {
                if (pass <= MAX_MIRRORS) {
                    mirror(ray, primitive);
                    selected[moved++] = (short) ray;
                }
            } else if (primitive >= 0 && (materials.isTransparent(primitives.material[primitive])
                    || geometry.isLightFace(primitive) && !hasEntered[ray])) {
                if (pass > MAX_SURFACES) {
                    rays.primitive[ray] = -1;
                    allocateTints();
                    multiplyTint(ray, Rgb.BLACK, 1);
                } else {
                    moveThroughSurface(ray, primitive, pass);
                    selected[moved++] = (short) ray;
                }
            }
        }
        return moved;
    }

    /** Sends a ray on in the mirrored direction. */
    private void mirror(int ray, int primitive) {
        computeSurface(ray, primitive);
        SurfacePoint.writeReflection(surface.nx, surface.ny, surface.nz, (float) rays.dx[ray], (float) rays.dy[ray], (float) rays.dz[ray],
                direction);
        allocateTints();
        multiplyTint(ray, requireNonNull(mirrors[primitives.material[primitive]]), 1);
        passed[ray] += rays.t[ray];
        isMirrored[ray] = true;
        sendOn(ray, surface.px, surface.py, surface.pz);
    }

    /** Returns whether a ray met a mirror on its way. */
    public boolean isMirrored(int ray) {
        return isMirrored[ray];
    }

    /** Returns whether a ray entered a frosted body, which bends it. */
    public boolean hasEntered(int ray) {
        return hasEntered[ray];
    }

    private void moveThroughSurface(int ray, int primitive, int pass) {
        computeSurface(ray, primitive);
        surface.computeBackPoint();
        int material = primitives.material[primitive];
        boolean isEntry = pass == 1 && enters[ray] && materials.material(material).isFrosted() && !surface.isInside();
        hasEntered[ray] |= isEntry || bends[material];
        if (!isEntry && bends[material]) {
            bend(ray, material, pass);
            return;
        }
        if (!isEntry && materials.isTransparent(material)) {
            multiplyTransmittance(ray, material);
        }
        passed[ray] += rays.t[ray];
        startX[ray] = surface.backX;
        startY[ray] = surface.backY;
        startZ[ray] = surface.backZ;
    }

    /**
     * Sends a ray on through the surface of a frosted body computed last. Where it leaves, nothing is reflected: light that stays inside leaves
     * elsewhere. At total reflection it stays inside for a few times.
     */
    private void bend(int ray, int material, int pass) {
        Transmission transmission = materials.transmission(material);
        boolean isInside = surface.isInside();
        float vx = (float) rays.dx[ray];
        float vy = (float) rays.dy[ray];
        float vz = (float) rays.dz[ray];
        allocateTints();
        if (isInside && transmission.isTinted()) {
            multiplyTint(ray, transmission.tint(), rays.t[ray] / transmission.tintDistance());
        }
        passed[ray] += rays.t[ray];
        boolean passes = Refraction.writeDirection(surface.nx, surface.ny, surface.nz, vx, vy, vz,
                Refraction.eta(transmission, isInside), direction);
        if (!passes && pass <= MAX_INTERNAL) {
            SurfacePoint.writeReflection(surface.nx, surface.ny, surface.nz, vx, vy, vz, direction);
            sendOn(ray, surface.px, surface.py, surface.pz);
            return;
        }
        float reflectance = isInside ? 0
                : Refraction.fresnelReflectance(transmission, false, surface.nx, surface.ny, surface.nz, vx, vy, vz);
        for (int c = 0; c < 3; c++) {
            tint[c][ray] *= materials.transmitted(material, reflectance, c);
        }
        if (!passes) {
            direction[0] = vx;
            direction[1] = vy;
            direction[2] = vz;
        }
        sendOn(ray, surface.backX, surface.backY, surface.backZ);
    }

    private void sendOn(int ray, float x, float y, float z) {
        startX[ray] = x;
        startY[ray] = y;
        startZ[ray] = z;
        rays.dx[ray] = direction[0];
        rays.dy[ray] = direction[1];
        rays.dz[ray] = direction[2];
    }

    /** Multiplies the tint of a ray by the transmittance of the surface computed last. */
    private void multiplyTransmittance(int ray, int material) {
        allocateTints();
        Transmission transmission = materials.transmission(material);
        float reflectance = Refraction.fresnelReflectance(transmission, false, surface.nx, surface.ny, surface.nz, (float) rays.dx[ray],
                (float) rays.dy[ray], (float) rays.dz[ray]);
        for (int c = 0; c < 3; c++) {
            tint[c][ray] *= materials.transmitted(material, reflectance, c);
        }
        double inside = SurfacePointBuilder.insideDistance(transmission, surface, rays.t[ray]);
        if (inside >= 0) {
            multiplyTint(ray, transmission.tint(), inside / transmission.tintDistance());
        }
    }

    private void allocateTints() {
        if (!tinted) {
            tinted = true;
            for (float[] channel : tint) {
                Arrays.fill(channel, 1);
            }
        }
    }

    private void computeSurface(int ray, int primitive) {
        surface.compute(primitives, primitive, rays.part[ray], startX[ray], startY[ray], startZ[ray], rays.dx[ray], rays.dy[ray],
                rays.dz[ray], rays.t[ray]);
    }

    private void multiplyTint(int ray, Rgb color, double power) {
        tint[0][ray] *= (float) StrictMath.pow(color.r(), power);
        tint[1][ray] *= (float) StrictMath.pow(color.g(), power);
        tint[2][ray] *= (float) StrictMath.pow(color.b(), power);
    }

    /** Returns whether any ray passed a transparent surface. */
    public boolean isTinted() {
        return tinted;
    }

    /** Returns the primitive that a ray hit, −1 for a miss. */
    public int primitive(int ray) {
        return rays.primitive[ray];
    }

    /** Returns the length of a ray that hit, in lengths of its direction. */
    public double distance(int ray) {
        return passed[ray] + rays.t[ray];
    }

    /** Returns whether a primitive may be shaded by other normals than those of its surface. */
    public boolean hasShadingNormals(int primitive) {
        return primitives.hasShadingNormals(primitive);
    }

    /**
     * Returns the normal of the surface that a ray hit, not bent by bump maps or vertex normals: of length 1, facing the ray; null if the
     * surface is shaded by this normal.
     */
    public @Nullable Vec3 geometricNormal(int ray) {
        computeSurface(ray, rays.primitive[ray]);
        return surface.hasShadingNormal() ? surface.geometricNormal() : null;
    }

    /**
     * Moves the start of a ray to the surface that it hit, on the side that it came from. Vertex normals do not lift it. Returns the normal, as
     * {@link #geometricNormal}.
     */
    public @Nullable Vec3 moveToSurface(int ray) {
        Vec3 normal = geometricNormal(ray);
        surface.computeFacetPoint();
        startX[ray] = surface.facetX;
        startY[ray] = surface.facetY;
        startZ[ray] = surface.facetZ;
        return normal;
    }

    /**
     * Makes ray {@code to} the rest of a ray behind the surface that it hit.
     *
     * @param to at most {@code ray}
     */
    public void moveBehind(int ray, int to) {
        computeSurface(ray, rays.primitive[ray]);
        surface.computeBackPoint();
        startX[to] = surface.backX;
        startY[to] = surface.backY;
        startZ[to] = surface.backZ;
        directionX[to] = directionX[ray];
        directionY[to] = directionY[ray];
        directionZ[to] = directionZ[ray];
    }

    /**
     * Replaces the texels of the rows returned last by means over squares on their surfaces.
     *
     * @param sides side of each row's square, scene units
     */
    public void writeMeanTexels(HitRows rows, double[] sides) {
        rowBuilder.writeMeanTexels(rows, rays, sides);
    }

    /** Returns the hits sorted by material; {@code parent} is the ray. */
    public HitRows rows(TileVisibility.Allocator allocator) {
        return rowBuilder.build(rays, null, allocator);
    }

    /** Returns the hits as {@link #rows}, but without their texels. */
    public HitRows rowsWithoutTexels() {
        return rowBuilder.build(rays, null, false, (hits, texels, transparent) -> new HitRows(hits, texels, transparent, false, false));
    }
}

package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import java.lang.ref.SoftReference;
import java.lang.ref.WeakReference;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.primitive.LightBuffers;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.solid.SurfaceContact;
import lightning.render.trace.tree.BoxSet;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.RayTraversal;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/**
 * A scene's shapes and materials in render space, without its lights, as rays intersect them.
 *
 * <p>Shapes and their BVH are built once for all scenes that differ only in lights and materials. The topology of the BVH,
 * which takes most of the time to build, is shared by all cameras. Thread-safe.
 */
public final class Geometry {
    /** More meshes have no light buffers. */
    private static final int MAX_BUFFERED_MESHES = 64;

    private final ShapeSurfaces surfaces;
    private final ShadowBlockers blockers;
    private final Scene scene;
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    /** BVH over the primitives that rays of this geometry meet. */
    private final Bvh bvh;
    /** BVH over all primitives. */
    final Bvh all;
    /** Primitives that rays other than shadow rays meet; null if all are. */
    private final boolean @Nullable [] seen;
    private final boolean castsShadows;
    /** Meshes among {@link #tintCasters} that do not contain the eye, ascending. */
    private final int[] tintMeshes;
    /** Light buffers by the array of the area's x coordinates. Guarded by itself. */
    private final Map<double[], SoftReference<LightBuffers>> lightBuffers = new WeakHashMap<>();
    /** True if any material casts no shadows. */
    private final boolean hasShadowlessMaterials;
    /** Versions of this geometry in which only some shapes cast shadows, by the linked shapes. */
    private final Map<ShapeLinks, Geometry> shadowGeometries = new ConcurrentHashMap<>();
    /**
     * Latest result of {@link #changeTo}, while another object still references it. Any thread may write it, since all compute
     * equal results.
     */
    private volatile @Nullable WeakReference<ShapeChange> lastChange;

    /**
     * @param all  BVH over all primitives
     * @param cast BVH over those that cast shadows, for a geometry of shadow rays; null for one of other rays
     */
    private Geometry(ShapeSurfaces surfaces, Bvh all, @Nullable Bvh cast, ShadowBlockers blockers) {
        this.surfaces = surfaces;
        scene = surfaces.scene();
        materials = surfaces.materials();
        this.all = all;
        primitives = all.primitives;
        this.blockers = blockers;
        seen = cast == null ? seenPrimitives() : null;
        bvh = cast != null ? cast : seen == null ? all : all.subset(seen);
        castsShadows = blockers.castShadows();
        tintMeshes = tintMeshes();
        hasShadowlessMaterials = materials.hasShadowlessMaterials();
    }

    private Geometry(ShapeSurfaces surfaces, Bvh all) {
        this(surfaces, all, null, ShadowBlockers.ALL);
    }

    private boolean @Nullable [] seenPrimitives() {
        if (!materials.hasUnseenMaterials()) {
            return null;
        }
        boolean[] result = new boolean[primitives.count];
        for (int s = 0; s < result.length; s++) {
            result[s] = material(s).transmission().isSeen();
        }
        return result;
    }

    /** Prepares the shapes of a scene. */
    public static Geometry of(Scene scene) {
        return of(scene, MaterialTable.CASTS_REFLECTIONS);
    }

    /**
     * Prepares the shapes of a scene.
     *
     * @param castsReflections selects the materials that cast reflected rays: all reflective ones, and possibly others
     */
    public static Geometry of(Scene scene, Predicate<Material> castsReflections) {
        ShapeSurfaces surfaces = ShapeSurfaces.of(scene, castsReflections);
        return new Geometry(surfaces, new Bvh(surfaces.primitives()));
    }

    private Geometry withMaterials(Scene other) {
        return new Geometry(surfaces.withMaterialsOf(other, castsReflections()), all);
    }

    /** Returns a version in which only some primitives cast shadows; the BVH contains only these. */
    private Geometry withBlockers(boolean[] newShadowCasters, boolean @Nullable [] newTintCasters) {
        var changed = new ShadowBlockers(newShadowCasters, newTintCasters, newTintCasters == null ? null : all.subset(newTintCasters));
        return new Geometry(surfaces, all, all.subset(newShadowCasters), changed);
    }

    /** Returns these shapes seen by another camera; reuses the topology of the BVH. */
    private Geometry seenFrom(Scene other, Predicate<Material> newCastsReflections) {
        return new Geometry(surfaces.withMaterialsOf(other, newCastsReflections),
                new Bvh(primitives.movedCamera(other.camera().origin(), other.camera().lens().aperture()), all));
    }

    /** Returns other shapes seen from the same camera position; materials keep their indices. */
    private Geometry withShapes(Scene other) {
        ShapeSurfaces changed = surfaces.withShapesOf(other);
        return new Geometry(changed, Bvh.refitOrRebuild(changed.primitives(), all));
    }

    /** Returns for each primitive whether it belongs to a linked shape; callers must not modify the array. */
    public boolean[] linkedPrimitives(ShapeLinks links) {
        // Every shape is one primitive.
        return scene.stage().linkMask(links);
    }

    /**
     * Returns the geometry for shadow rays of a light that only linked shapes shadow. Primitives keep their indices and boxes.
     */
    public Geometry shadowGeometry(ShapeLinks links) {
        return links.isAll() && !hasShadowlessMaterials && seen == null ? this
                : shadowGeometries.computeIfAbsent(links,
                        requested -> withBlockers(shadowCasters(requested), tintCasters(requested)));
    }

    /** Returns for each primitive whether it casts shadows from a light with these links; callers must not modify the array. */
    boolean[] shadowCasters(ShapeLinks links) {
        boolean[] linked = linkedPrimitives(links);
        if (!hasShadowlessMaterials) {
            return linked;
        }
        boolean[] result = linked.clone();
        for (int s = 0; s < result.length; s++) {
            result[s] &= material(s).transmission().castsShadows();
        }
        return result;
    }

    /** Returns for each primitive whether it tints light with these shadow links; null if none does. */
    boolean @Nullable [] tintCasters(ShapeLinks links) {
        if (!primitives.hasShadowTints()) {
            return null;
        }
        boolean[] result = linkedPrimitives(links).clone();
        boolean hasTints = false;
        for (int s = 0; s < result.length; s++) {
            result[s] &= primitives.shadowTint(s) != null;
            hasTints |= result[s];
        }
        return hasTints ? result : null;
    }

    /**
     * Returns for each primitive whether it transmits and tints light, or null if none does; callers must not modify the array.
     */
    public boolean @Nullable [] tintCasters() {
        return blockers.tintCasters();
    }

    /** Returns the BVH over the primitives that transmit and tint light; null if there are none. */
    public @Nullable Bvh tintBvh() {
        return blockers.tintBvh();
    }

    /**
     * Returns the light buffers of the meshes that transmit and tint light, for the sample points of an area light; null if there
     * are none. They are shared while any thread uses them and memory suffices.
     *
     * @param x coordinates in render space, with {@code y} and {@code z}: the same arrays for the same area
     */
    public @Nullable LightBuffers tintLightBuffers(double[] x, double[] y, double[] z) {
        if (tintMeshes.length == 0 || tintMeshes.length > MAX_BUFFERED_MESHES) {
            return null;
        }
        synchronized (lightBuffers) {
            SoftReference<LightBuffers> reference = lightBuffers.get(x);
            LightBuffers result = reference == null ? null : reference.get();
            if (result == null) {
                result = new LightBuffers(primitives, tintMeshes, x, y, z);
                lightBuffers.put(x, new SoftReference<>(result));
            }
            return result;
        }
    }

    private int[] tintMeshes() {
        boolean[] tintCasters = tintCasters();
        if (tintCasters == null) {
            return new int[0];
        }
        return IntStream.range(0, tintCasters.length)
                .filter(s -> tintCasters[s] && primitives.mesh(s) != null && !primitives.isEyeOnSurface(s))
                .toArray();
    }

    /**
     * Writes the hits of a shadow ray, numbered 0, on transmitting primitives. Tests every primitive and every triangle.
     *
     * @param target {@link ShadowRayTarget#OFF_SURFACE} for an unbounded ray
     * @param limit 1 for a shadow ray to a point; {@code +∞} for an unbounded ray
     */
    public void collectHitsBruteForce(Ray shadowRay, ShadowRayTarget target, double limit, ShadowRayHits hits) {
        MeshRayQuery probe = new MeshRayQuery();
        Vec3 o = shadowRay.origin();
        Vec3 d = shadowRay.direction();
        hits.clear();
        hits.selectRay(0);
        boolean[] tintCasters = tintCasters();
        for (int s = 0; tintCasters != null && s < tintCasters.length; s++) {
            if (tintCasters[s]) {
                primitives.addHits(s, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), target.touches(s, o), limit, probe, true, hits);
            }
        }
    }

    /** Returns whether any primitive casts shadows. If none does, no shadow rays may be traced. */
    public boolean castsShadows() {
        return castsShadows;
    }

    boolean isShadowCaster(int primitive) {
        return blockers.shadowCasters() == null || blockers.shadowCasters()[primitive];
    }

    /** Returns whether {@code other} has these shapes, seen from this camera position; its materials may differ, and its lens a little. */
    public boolean canServe(Scene other) {
        return hasSameShapes(other) && scene.camera().origin().equals(other.camera().origin())
                && other.camera().lens().aperture() <= primitives.maxLens;
    }

    private boolean hasSameShapes(Scene other) {
        return scene.stage().rendered().nodes().equals(other.stage().rendered().nodes()) && hasSameRays(other);
    }

    /** Returns whether another scene's materials produce the same hits: equal normal mapping, refraction and shadow casting. */
    private boolean hasSameRays(Scene other) {
        Stage stage = scene.stage().rendered();
        Stage otherStage = other.stage().rendered();
        if (stage.materials() == otherStage.materials()) {
            return true;
        }
        Map<String, Material> thisMaterials = stage.materialsByName();
        Map<String, Material> otherMaterials = otherStage.materialsByName();
        return stage.usedMaterials().stream()
                .allMatch(m -> requireNonNull(thisMaterials.get(m)).hasSameRays(requireNonNull(otherMaterials.get(m))));
    }

    /**
     * Returns whether a scene has these shapes and an eye at a point of it is within the range of coordinates of this render
     * space.
     */
    public boolean canServeEye(Scene other, Vec3 eye) {
        return hasSameShapes(other) && toRenderSpace(eye).maxAbs() <= primitives.maxCoordinate;
    }

    /** Returns the origin of render space in scene coordinates. */
    public Vec3 origin() {
        return scene.camera().origin();
    }

    /**
     * Returns the geometry of another scene and reuses as much of this one as possible.
     * <ul>
     * <li>Same shapes and camera position: returns this geometry, with the other scene's materials.</li>
     * <li>Same shapes, other camera position: reuses the BVH topology with moved boxes.</li>
     * <li>Otherwise: builds a new geometry.</li>
     * </ul>
     *
     * @param newCastsReflections selects the materials that cast reflected rays
     */
    public Geometry forScene(Scene other, Predicate<Material> newCastsReflections) {
        if (!hasSameShapes(other)) {
            return of(other, newCastsReflections);
        }
        return canServe(other) && castsReflections() == newCastsReflections ? withMaterialsOf(other)
                : seenFrom(other, newCastsReflections);
    }

    /**
     * Returns the names of all materials that a shape has or had, in the order of their indices, which follows edits; empty if the scene lacks one of
     * them.
     */
    public Optional<List<String>> materialNames() {
        return surfaces.hasAllMaterials() ? Optional.of(surfaces.materialNames()) : Optional.empty();
    }

    /**
     * Returns these shapes with other indices of materials, which earlier edits would have led to.
     *
     * @param names result of {@link #materialNames} for an equal scene
     * @throws IllegalArgumentException if a material in use is missing, a name is there twice, or the scene lacks it
     */
    public Geometry withMaterialNames(List<String> names) {
        List<String> own = surfaces.materialNames();
        if (names.equals(own)) {
            return this;
        }
        if (Set.copyOf(names).size() < names.size() || !names.containsAll(own)
                || !scene.stage().rendered().materialsByName().keySet().containsAll(names)) {
            throw new IllegalArgumentException("expected the materials " + own + " in any order, with others of the scene, found " + names);
        }
        ShapeSurfaces changed = surfaces.withMaterialNames(names);
        return new Geometry(changed, Bvh.refitOrRebuild(changed.primitives(), all));
    }

    /**
     * Returns these shapes with the materials of another scene; each material keeps its index.
     *
     * @throws IllegalArgumentException if {@link #canServe} is false for that scene
     */
    public Geometry withMaterialsOf(Scene other) {
        if (!canServe(other)) {
            throw new IllegalArgumentException("the geometry belongs to another scene");
        }
        return scene.stage().rendered().materials().equals(other.stage().rendered().materials()) ? this : withMaterials(other);
    }

    /**
     * Computes the difference between these shapes and those of another scene seen from the same position. Materials keep their
     * indices in the new geometry.
     */
    public ShapeChange changeTo(Scene other) {
        ShapeChange current = lastChange == null ? null : lastChange.get();
        if (current == null || !current.after(this).hasSameShapes(other)) {
            current = ShapeChange.of(this, withShapes(other));
            lastChange = new WeakReference<>(current);
        }
        return current;
    }

    /** Computes the difference to a geometry that was derived from this one, possibly in several steps. */
    public ShapeChange changeTo(Geometry later) {
        return ShapeChange.of(this, later);
    }

    /** Returns the predicate that selects the materials that cast reflected rays. */
    public Predicate<Material> castsReflections() {
        return surfaces.castsReflections();
    }

    public MaterialTable materials() {
        return materials;
    }

    /** Returns the number of primitives. */
    public int primitiveCount() {
        return primitives.count;
    }

    /** Returns the index of the shape that a primitive belongs to. */
    public int owner(int primitive) {
        return primitives.owner[primitive];
    }

    /** Returns the shape that a primitive belongs to. */
    public Shape shape(int primitive) {
        return surfaces.shapes().get(owner(primitive));
    }

    /** Returns whether a primitive is the face of a visible light, whose name its {@link #shape} has: it is no object of the scene. */
    public boolean isLightFace(int primitive) {
        return owner(primitive) >= scene.stage().shapes().size();
    }

    /** Returns whether the scene has visible lights. */
    boolean hasLightFaces() {
        return surfaces.shapes().size() > scene.stage().shapes().size();
    }

    /** Returns whether a bump or normal map bends the normals of a primitive. */
    public boolean hasBentNormals(int primitive) {
        return material(primitive).bumpMapping().bendsNormals();
    }

    /** Returns the material of a primitive. */
    public Material material(int primitive) {
        return materials.material(materialIndex(primitive));
    }

    /** Returns the index of the material of a primitive. */
    public int materialIndex(int primitive) {
        return primitives.material[primitive];
    }

    public PrimitiveTable primitives() {
        return primitives;
    }

    /** Returns the BVH over the primitives that its rays meet. */
    public Bvh bvh() {
        return bvh;
    }

    /** Returns the boxes of some primitives, also of those that its rays do not meet. */
    public BoxSet boxes(int[] ofPrimitives, int count) {
        return BoxSet.of(all, ofPrimitives, count);
    }

    /** Returns whether rays other than shadow rays meet a primitive. */
    public boolean isSeen(int primitive) {
        return seen == null || seen[primitive];
    }

    /** Converts a point from scene coordinates to render space. */
    public Vec3 toRenderSpace(Vec3 world) {
        return world.minus(scene.camera().origin());
    }

    /** Converts a point from render space to scene coordinates. */
    public Vec3 toScene(Vec3 render) {
        return render.plus(scene.camera().origin());
    }

    /**
     * Returns the primitive that a ray hits first. Tests every primitive, but meshes by their BVHs, which accept any origin.
     * (The BVH over the primitives does not.)
     */
    public int nearestLinear(Ray ray) {
        return bvh.traversal(ray).nearestBruteForce();
    }

    /**
     * Returns the primitive that a ray hits first, by the BVH. The origin must be the camera or lie within the scene's bounds.
     */
    public int nearest(Ray ray) {
        return bvh.nearest(ray);
    }

    /** Returns whether the ray hits any primitive at a distance below {@code limit}, by the BVH. */
    public boolean isBlocked(Ray ray, double limit) {
        return bvh.isBlocked(ray, limit);
    }

    /** Returns the target for shadow rays to a light at a point in render space, on any primitive, also of those that its rays do not meet. */
    public ShadowRayTarget shadowRayTarget(Vec3 point) {
        return ShadowRayTarget.find(point, all);
    }

    /**
     * Returns the blocker nearest to a point on its shadow ray to a light, both in render space, by the BVH.
     *
     * @return the primitive's index, or −1 if the light is visible
     */
    public int blocker(Vec3 point, ShadowRayTarget target) {
        return bvh.blocker(new Ray(point, target.point().minus(point)), target);
    }

    /** Returns the distance along a ray to a primitive, or {@code +∞}. */
    public double distance(int primitive, Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return primitives.distance(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    }

    /** Returns the distance along a shadow ray, 1 at the light, to a blocking primitive; {@code +∞} if it does not block. */
    public double distance(int primitive, Ray shadowRay, ShadowRayTarget target) {
        Vec3 o = shadowRay.origin();
        Vec3 d = shadowRay.direction();
        return target.touches(primitive, o) ? primitives.distance(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), SurfaceContact.END)
                : distance(primitive, shadowRay);
    }

    /**
     * Computes the surface point where a ray hits a primitive; tests meshes by their BVHs.
     *
     * @throws IllegalArgumentException if the ray misses the primitive
     */
    public SurfacePoint surface(int primitive, Ray ray) {
        RayTraversal traversal = bvh.traversal(ray);
        return traversal.intersectPrimitive(primitive) < 0 ? throwMissed(primitive)
                : new SurfacePointBuilder(primitives, materials).surfacePoint(primitive, traversal.part(), ray, traversal.distance(), true);
    }

    /**
     * Returns the place on its shape where a ray hits a primitive; tests meshes by their BVHs.
     *
     * @throws IllegalArgumentException if the ray misses the primitive
     */
    public SurfaceLocation location(int primitive, Ray ray) {
        RayTraversal traversal = bvh.traversal(ray);
        if (traversal.intersectPrimitive(primitive) < 0) {
            throwMissed(primitive);
        }
        return new SurfacePointBuilder(primitives, materials).location(primitive, traversal.part(), ray, traversal.distance());
    }

    /**
     * Returns the steps from the geometric normal to the shading normal at a ray's hit; null if both are equal.
     *
     * @throws IllegalArgumentException if the ray misses the primitive
     */
    public @Nullable NormalSteps normalSteps(int primitive, Ray ray) {
        RayTraversal traversal = bvh.traversal(ray);
        if (traversal.intersectPrimitive(primitive) < 0) {
            throwMissed(primitive);
        }
        return new SurfacePointBuilder(primitives, materials).normalSteps(primitive, traversal.part(), ray, traversal.distance());
    }

    private static SurfacePoint throwMissed(int primitive) {
        throw new IllegalArgumentException("the ray misses primitive " + primitive);
    }
}

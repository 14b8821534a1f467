package lightning.render.trace;

import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SurfaceContact;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.RayTraversal;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.ShapeLinks;

/**
 * What rays can meet: a scene's shapes and materials in render space, without its lights.
 *
 * <p>Shapes and their tree of boxes are built once for all scenes that differ in lights and materials only, and the form
 * of the tree, which takes the time, for all cameras. Shared between threads.
 */
public final class Geometry {
    private final Scene scene;
    private final List<Shape> shapes;
    private final List<String> materialNames;
    private final Set<String> vertexColorMaterials;
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final Bvh bvh;
    private final Predicate<Material> castsReflections;
    /** Which primitives throw shadows; null where all do. */
    private final boolean[] shadowCasters;
    private final boolean castsShadows;
    /** The tree of those primitives that light passes and takes the color of; null where it passes none. */
    private final Bvh tintBvh;
    private final boolean[] tintCasters;
    /** Whether any material throws no shadows. */
    private final boolean hasShadowlessMaterials;
    /** The same shapes where some of them throw no shadow, by those that do. */
    private final Map<ShapeLinks, Geometry> shadowGeometries = new ConcurrentHashMap<>();
    /** What {@link #changeTo} found last, as long as someone else uses it. Any thread may set it: each that does is right. */
    private volatile WeakReference<ShapeChange> lastChange;

    /** Prepares the shapes of a scene. */
    public Geometry(Scene scene) {
        this(scene, MaterialTable.CASTS_REFLECTIONS);
    }

    /**
     * Prepares the shapes of a scene.
     *
     * @param castsReflections which materials cast mirrored rays: all that mirror, and perhaps others
     */
    public Geometry(Scene scene, Predicate<Material> castsReflections) {
        this.scene = scene;
        shapes = scene.stage().shapes();
        materialNames = MaterialTable.materialNames(shapes);
        vertexColorMaterials = MaterialTable.vertexColorMaterials(shapes);
        this.castsReflections = castsReflections;
        materials = new MaterialTable(materialNames, vertexColorMaterials, scene, null, castsReflections);
        bvh = new Bvh(PrimitiveTable.of(scene.stage(), materialIndices(), scene.camera().origin()));
        primitives = bvh.primitives;
        shadowCasters = null;
        castsShadows = true;
        tintBvh = null;
        tintCasters = null;
        hasShadowlessMaterials = materials.hasShadowlessMaterials();
    }

    private Geometry(Geometry source, Scene scene) {
        this.scene = scene;
        shapes = source.shapes;
        materialNames = source.materialNames;
        vertexColorMaterials = source.vertexColorMaterials;
        castsReflections = source.castsReflections;
        materials = new MaterialTable(materialNames, vertexColorMaterials, scene, source.materials, castsReflections);
        primitives = source.primitives;
        bvh = source.bvh;
        shadowCasters = source.shadowCasters;
        castsShadows = source.castsShadows;
        tintBvh = source.tintBvh;
        tintCasters = source.tintCasters;
        hasShadowlessMaterials = materials.hasShadowlessMaterials();
    }

    /** The same of which only some primitives throw shadows: the tree has no others. */
    private Geometry(Geometry source, boolean[] shadowCasters, boolean[] tintCasters) {
        scene = source.scene;
        shapes = source.shapes;
        materialNames = source.materialNames;
        vertexColorMaterials = source.vertexColorMaterials;
        castsReflections = source.castsReflections;
        materials = source.materials;
        primitives = source.primitives;
        this.shadowCasters = shadowCasters;
        castsShadows = IntStream.range(0, shadowCasters.length).anyMatch(s -> shadowCasters[s]);
        hasShadowlessMaterials = source.hasShadowlessMaterials;
        bvh = castsShadows ? source.bvh.subset(shadowCasters) : source.bvh;
        this.tintCasters = tintCasters;
        tintBvh = tintCasters == null ? null : source.bvh.subset(tintCasters);
    }

    /** The form of the tree is another's. */
    private Geometry(Geometry source, Scene scene, Predicate<Material> castsReflections) {
        this.scene = scene;
        shapes = source.shapes;
        materialNames = source.materialNames;
        vertexColorMaterials = source.vertexColorMaterials;
        this.castsReflections = castsReflections;
        materials = new MaterialTable(materialNames, vertexColorMaterials, scene, source.materials, castsReflections);
        bvh = new Bvh(source.primitives.movedCamera(scene.camera().origin()), source.bvh);
        primitives = bvh.primitives;
        shadowCasters = null;
        castsShadows = true;
        tintBvh = null;
        tintCasters = null;
        hasShadowlessMaterials = materials.hasShadowlessMaterials();
    }

    /** Other shapes, seen from the same place; materials keep their indices. */
    private Geometry(Scene scene, Geometry previous) {
        this.scene = scene;
        shapes = scene.stage().shapes();
        materialNames = MaterialTable.materialNames(previous.materialNames, shapes);
        vertexColorMaterials = MaterialTable.vertexColorMaterials(shapes);
        castsReflections = previous.castsReflections;
        materials = new MaterialTable(materialNames, vertexColorMaterials, scene, previous.materials, castsReflections);
        bvh = Bvh.refitOrRebuild(PrimitiveTable.of(scene.stage(), materialIndices(), scene.camera().origin()), previous.bvh);
        primitives = bvh.primitives;
        shadowCasters = null;
        castsShadows = true;
        tintBvh = null;
        tintCasters = null;
        hasShadowlessMaterials = materials.hasShadowlessMaterials();
    }

    /** Of each primitive whether it is of a linked shape; not to be written to. */
    public boolean[] linkedPrimitives(ShapeLinks links) {
        // Every shape is one primitive.
        return scene.stage().linkMask(links);
    }

    /** What ways to a light meet that some shapes do not shadow: primitives keep their indices and their boxes. */
    public Geometry shadowGeometry(ShapeLinks links) {
        return links.isAll() && !hasShadowlessMaterials ? this
                : shadowGeometries.computeIfAbsent(links,
                        requested -> new Geometry(this, shadowCasters(requested), tintCasters(requested)));
    }

    /** Of each primitive whether it throws shadows in a light that linked shapes shadow; not to be written to. */
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

    /** Of each primitive whether it gives its color to the light that linked shapes shadow; null where none does. */
    boolean[] tintCasters(ShapeLinks links) {
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

    /** Of each primitive whether light passes it and takes its color; null where it passes none; not to be written to. */
    public boolean[] tintCasters() {
        return tintCasters;
    }

    /** The tree of those primitives that light passes and takes the color of; null where it passes none. */
    public Bvh tintBvh() {
        return tintBvh;
    }

    /**
     * Writes where a way meets what light passes, as way 0; every primitive is asked, and every triangle.
     *
     * @param target   {@link ShadowRayTarget#OFF_SURFACE} for a ray
     * @param limit 1 for a way to a point; {@code +∞} for a ray
     */
    public void collectHitsBruteForce(Ray shadowRay, ShadowRayTarget target, double limit, ShadowRayHits hits) {
        MeshRayQuery probe = new MeshRayQuery();
        Vec3 o = shadowRay.origin();
        Vec3 d = shadowRay.direction();
        hits.clear();
        hits.selectRay(0);
        for (int s = 0; tintCasters != null && s < tintCasters.length; s++) {
            if (tintCasters[s]) {
                primitives.addHits(s, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), target.touches(s, o), limit, probe, true, hits);
            }
        }
    }

    /** Whether any primitive throws a shadow; where none does, rays must not be asked. */
    public boolean castsShadows() {
        return castsShadows;
    }

    private boolean isShadowCaster(int primitive) {
        return shadowCasters == null || shadowCasters[primitive];
    }

    private int[] materialIndices() {
        Map<String, Integer> index = new HashMap<>();
        materialNames.forEach(name -> index.put(name, index.size()));
        return shapes.stream().mapToInt(s -> index.get(s.material())).toArray();
    }

    /** Whether the shapes of {@code other} are these, seen from this place; its materials may be others. */
    public boolean canServe(Scene other) {
        return hasSameShapes(other) && scene.camera().origin().equals(other.camera().origin());
    }

    private boolean hasSameShapes(Scene other) {
        return scene.nodes().equals(other.nodes()) && hasSameRays(other);
    }

    /**
     * Whether the materials that shapes have bend normals as those of another scene do, lead rays on behind them and throw shadows:
     * what is met is told with its normal and with where rays go on.
     */
    private boolean hasSameRays(Scene other) {
        if (scene.materials() == other.materials()) {
            return true;
        }
        Map<String, Material> thisMaterials = scene.materialsByName();
        Map<String, Material> otherMaterials = other.materialsByName();
        return scene.stage().usedMaterials().stream().allMatch(m -> thisMaterials.get(m).hasSameRays(otherMaterials.get(m)));
    }

    /** Whether these are the shapes of a scene, and an eye may stand at a point of it without their being moved. */
    public boolean canServeEye(Scene other, Vec3 eye) {
        return hasSameShapes(other) && toRenderSpace(eye).maxAbs() <= primitives.maxCoordinate;
    }

    /** Where render space begins, a point of the scene. */
    public Vec3 origin() {
        return scene.camera().origin();
    }

    /**
     * What rays of another scene can meet: this itself where it serves that scene, its tree with moved boxes where shapes are
     * the same and the camera stands elsewhere, and else built anew.
     *
     * @param newCastsReflections as for a new one
     */
    public Geometry forScene(Scene other, Predicate<Material> newCastsReflections) {
        if (!hasSameShapes(other)) {
            return new Geometry(other, newCastsReflections);
        }
        return canServe(other) && castsReflections == newCastsReflections ? withMaterialsOf(other)
                : new Geometry(this, other, newCastsReflections);
    }

    /**
     * The same shapes with the materials of another scene, each at the same index as here.
     *
     * @throws IllegalArgumentException if this geometry does not serve that scene
     */
    public Geometry withMaterialsOf(Scene other) {
        if (!canServe(other)) {
            throw new IllegalArgumentException("the geometry is another scene's");
        }
        return scene.materials().equals(other.materials()) ? this : new Geometry(this, other);
    }

    /**
     * What becomes of these shapes where those of another scene follow, seen from the same place. Rows that know a material by its
     * index here know it by the same there.
     */
    public ShapeChange changeTo(Scene other) {
        ShapeChange current = lastChange == null ? null : lastChange.get();
        if (current == null || !current.after(this).hasSameShapes(other)) {
            current = new ShapeChange(this, new Geometry(other, this));
            lastChange = new WeakReference<>(current);
        }
        return current;
    }

    /** The same where those shapes are known already, of a geometry that followed from this one, perhaps in several steps. */
    public ShapeChange changeTo(Geometry later) {
        return new ShapeChange(this, later);
    }

    /** Which materials cast mirrored rays. */
    public Predicate<Material> castsReflections() {
        return castsReflections;
    }

    public MaterialTable materials() {
        return materials;
    }

    /** How many primitives there are. */
    public int primitiveCount() {
        return primitives.count;
    }

    /** The index of the shape that a primitive is of. */
    public int owner(int primitive) {
        return primitives.owner[primitive];
    }

    /** A number for the shape that a primitive is of, which it keeps whatever other shapes there are: of its name. */
    public int shapeHash(int primitive) {
        return HitCode.ofName(shape(primitive).name());
    }

    /** The shape that a primitive is of. */
    public Shape shape(int primitive) {
        return shapes.get(owner(primitive));
    }

    /** The material of a primitive. */
    public Material material(int primitive) {
        return materials.material(materialIndex(primitive));
    }

    /** The index of the material of a primitive. */
    public int materialIndex(int primitive) {
        return primitives.material[primitive];
    }

    public PrimitiveTable primitives() {
        return primitives;
    }

    /** The tree of boxes over the primitives. */
    public Bvh bvh() {
        return bvh;
    }

    /** Where a point of the scene lies in render space. */
    public Vec3 toRenderSpace(Vec3 world) {
        return world.minus(scene.camera().origin());
    }

    /** Where a point of render space lies in the scene. */
    public Vec3 toScene(Vec3 render) {
        return render.plus(scene.camera().origin());
    }

    /**
     * The primitive that a ray meets first: every one is asked, and every triangle of a mesh, none is skipped.
     *
     * @return its index, or −1
     */
    public int nearestBruteForce(Ray ray) {
        int nearest = -1;
        double minDistance = SolidGeometry.MISS;
        for (int s = 0; s < primitives.count; s++) {
            double t = distance(s, ray);
            if (t < minDistance) {
                minDistance = t;
                nearest = s;
            }
        }
        return nearest;
    }

    /** The same, where meshes are asked by their trees: these serve rays from anywhere, which the tree of primitives does not. */
    public int nearestLinear(Ray ray) {
        return bvh.traversal(ray).nearestBruteForce();
    }

    /** The same by the tree of boxes; origins are the camera or lie within the box of the scene. */
    public int nearest(Ray ray) {
        return bvh.nearest(ray);
    }

    /** Whether any primitive is met at a distance below {@code limit}, by the tree of boxes. */
    public boolean isBlocked(Ray ray, double limit) {
        return bvh.isBlocked(ray, limit);
    }

    /** Whether any primitive that throws shadows is met at a distance below {@code limit}; every one is asked. */
    public boolean isBlockedBruteForce(Ray ray, double limit) {
        for (int s = 0; s < primitives.count; s++) {
            if (isShadowCaster(s) && distance(s, ray) < limit) {
                return true;
            }
        }
        return false;
    }

    /** Where ways to a light at a point in render space end; every primitive is asked. */
    public ShadowRayTarget shadowRayTargetBruteForce(Vec3 point) {
        return ShadowRayTarget.findBruteForce(point, bvh);
    }

    /** The same by the tree of boxes. */
    public ShadowRayTarget shadowRayTarget(Vec3 point) {
        return ShadowRayTarget.find(point, bvh);
    }

    /** Whether any primitive that throws shadows stands between a point and a light, both in render space; every one is asked. */
    public boolean isBlockedBruteForce(Vec3 point, ShadowRayTarget target) {
        Ray shadowRay = new Ray(point, target.point().minus(point));
        for (int s = 0; s < primitives.count; s++) {
            if (isShadowCaster(s) && distance(s, shadowRay, target) < 1) {
                return true;
            }
        }
        return false;
    }

    /**
     * The primitive that stands nearest to a point on its way to a light, both in render space, by the tree of boxes.
     *
     * @return its index, or −1 where the way is free
     */
    public int blocker(Vec3 point, ShadowRayTarget target) {
        return bvh.blocker(new Ray(point, target.point().minus(point)), target);
    }

    /** The distance along a ray to a primitive, or {@code +∞}. */
    public double distance(int primitive, Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return primitives.distance(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    }

    /** The distance along the way to a light, 1 at the light, to a primitive that comes between; {@code +∞} where it does not. */
    public double distance(int primitive, Ray shadowRay, ShadowRayTarget target) {
        Vec3 o = shadowRay.origin();
        Vec3 d = shadowRay.direction();
        return target.touches(primitive, o) ? primitives.distance(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), SurfaceContact.END)
                : distance(primitive, shadowRay);
    }

    /**
     * What a ray meets on a primitive; a mesh is asked by its tree.
     *
     * @throws IllegalArgumentException if the ray misses the primitive
     */
    public SurfacePoint surface(int primitive, Ray ray) {
        RayTraversal traversal = bvh.traversal(ray);
        return traversal.intersectPrimitive(primitive) < 0 ? throwMissed(primitive)
                : new SurfacePointBuilder(primitives, materials).surfacePoint(primitive, traversal.part(), ray, traversal.distance());
    }

    /** The same; every triangle of a mesh is asked. */
    public SurfacePoint surfaceBruteForce(int primitive, Ray ray) {
        double t = distance(primitive, ray);
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return t == SolidGeometry.MISS ? throwMissed(primitive)
                : new SurfacePointBuilder(primitives, materials).surfacePoint(primitive,
                        primitives.hitPart(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z()), ray, t);
    }

    /**
     * How the normal came about by which a ray's hit on a primitive is shaded; null where it is the surface's own.
     *
     * @throws IllegalArgumentException if the ray misses the primitive
     */
    public NormalSteps normalSteps(int primitive, Ray ray) {
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

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
import lightning.render.trace.mesh.MeshProbe;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.Form;
import lightning.render.trace.solid.Touch;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.RayWalk;
import lightning.render.trace.tree.WayEnd;
import lightning.scene.Links;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Shape;

/**
 * What rays can meet: a scene's shapes and materials in render space, without its lights.
 *
 * <p>Shapes and their tree of boxes are built once for all scenes that differ in lights and materials only, and the form
 * of the tree, which takes the time, for all cameras. Shared between threads.
 */
public final class Geometry {
    private final Scene scene;
    private final List<Shape> shapes;
    private final List<String> names;
    private final Set<String> tinted;
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final Bvh bvh;
    private final Predicate<Material> mirrors;
    /** Which primitives throw shadows; null where all do. */
    private final boolean[] casters;
    private final boolean throwsShadows;
    /** The tree of those primitives that light passes and takes the colour of; null where it passes none. */
    private final Bvh tinting;
    private final boolean[] tinters;
    /** Whether any material throws no shadows. */
    private final boolean hasShadowless;
    /** The same shapes where some of them throw no shadow, by those that do. */
    private final Map<Links, Geometry> casting = new ConcurrentHashMap<>();
    /** What {@link #changeTo} found last, as long as someone else uses it. Any thread may set it: each that does is right. */
    private volatile WeakReference<ShapeChange> change;

    /** Prepares the shapes of a scene. */
    public Geometry(Scene scene) {
        this(scene, MaterialTable.MIRRORS);
    }

    /**
     * Prepares the shapes of a scene.
     *
     * @param mirrors which materials cast mirrored rays: all that mirror, and perhaps others
     */
    public Geometry(Scene scene, Predicate<Material> mirrors) {
        this.scene = scene;
        shapes = scene.stage().shapes();
        names = MaterialTable.names(shapes);
        tinted = MaterialTable.tinted(shapes);
        this.mirrors = mirrors;
        materials = new MaterialTable(names, tinted, scene, null, mirrors);
        bvh = new Bvh(PrimitiveTable.of(scene.stage(), materialOf(), scene.camera().origin()));
        primitives = bvh.primitives;
        casters = null;
        throwsShadows = true;
        tinting = null;
        tinters = null;
        hasShadowless = materials.hasShadowless();
    }

    private Geometry(Geometry shared, Scene scene) {
        this.scene = scene;
        shapes = shared.shapes;
        names = shared.names;
        tinted = shared.tinted;
        mirrors = shared.mirrors;
        materials = new MaterialTable(names, tinted, scene, shared.materials, mirrors);
        primitives = shared.primitives;
        bvh = shared.bvh;
        casters = shared.casters;
        throwsShadows = shared.throwsShadows;
        tinting = shared.tinting;
        tinters = shared.tinters;
        hasShadowless = materials.hasShadowless();
    }

    /** The same of which only some primitives throw shadows: the tree has no others. */
    private Geometry(Geometry shared, boolean[] casters, boolean[] tinters) {
        scene = shared.scene;
        shapes = shared.shapes;
        names = shared.names;
        tinted = shared.tinted;
        mirrors = shared.mirrors;
        materials = shared.materials;
        primitives = shared.primitives;
        this.casters = casters;
        throwsShadows = IntStream.range(0, casters.length).anyMatch(s -> casters[s]);
        hasShadowless = shared.hasShadowless;
        bvh = throwsShadows ? shared.bvh.only(casters) : shared.bvh;
        this.tinters = tinters;
        tinting = tinters == null ? null : shared.bvh.only(tinters);
    }

    /** The form of the tree is another's. */
    private Geometry(Geometry shared, Scene scene, Predicate<Material> mirrors) {
        this.scene = scene;
        shapes = shared.shapes;
        names = shared.names;
        tinted = shared.tinted;
        this.mirrors = mirrors;
        materials = new MaterialTable(names, tinted, scene, shared.materials, mirrors);
        bvh = new Bvh(shared.primitives.from(scene.camera().origin()), shared.bvh);
        primitives = bvh.primitives;
        casters = null;
        throwsShadows = true;
        tinting = null;
        tinters = null;
        hasShadowless = materials.hasShadowless();
    }

    /** Other shapes, seen from the same place; materials keep their indices. */
    private Geometry(Scene scene, Geometry before) {
        this.scene = scene;
        shapes = scene.stage().shapes();
        names = MaterialTable.names(before.names, shapes);
        tinted = MaterialTable.tinted(shapes);
        mirrors = before.mirrors;
        materials = new MaterialTable(names, tinted, scene, before.materials, mirrors);
        bvh = Bvh.following(PrimitiveTable.of(scene.stage(), materialOf(), scene.camera().origin()), before.bvh);
        primitives = bvh.primitives;
        casters = null;
        throwsShadows = true;
        tinting = null;
        tinters = null;
        hasShadowless = materials.hasShadowless();
    }

    /** Of each primitive whether it is of a linked shape; not to be written to. */
    public boolean[] linked(Links links) {
        // Every shape is one primitive.
        return scene.stage().linked(links);
    }

    /** What ways to a light meet that some shapes do not shadow: primitives keep their indices and their boxes. */
    public Geometry casting(Links links) {
        return links.isAll() && !hasShadowless ? this
                : casting.computeIfAbsent(links, asked -> new Geometry(this, casters(asked), tinters(asked)));
    }

    /** Of each primitive whether it throws shadows in a light that linked shapes shadow; not to be written to. */
    boolean[] casters(Links links) {
        boolean[] linked = linked(links);
        if (!hasShadowless) {
            return linked;
        }
        boolean[] casters = linked.clone();
        for (int s = 0; s < casters.length; s++) {
            casters[s] &= material(s).clarity().throwsShadows();
        }
        return casters;
    }

    /** Of each primitive whether it gives its colour to the light that linked shapes shadow; null where none does. */
    boolean[] tinters(Links links) {
        if (!primitives.haveTints()) {
            return null;
        }
        boolean[] tints = linked(links).clone();
        boolean any = false;
        for (int s = 0; s < tints.length; s++) {
            tints[s] &= primitives.tint(s) != null;
            any |= tints[s];
        }
        return any ? tints : null;
    }

    /** Of each primitive whether light passes it and takes its colour; null where it passes none; not to be written to. */
    public boolean[] tinters() {
        return tinters;
    }

    /** The tree of those primitives that light passes and takes the colour of; null where it passes none. */
    public Bvh tinting() {
        return tinting;
    }

    /**
     * Writes where a way meets what light passes, as way 0; every primitive is asked, and every triangle.
     *
     * @param end   {@link WayEnd#OPEN} for a ray
     * @param limit 1 for a way to a point; {@code +∞} for a ray
     */
    public void crossingsOfAll(Ray way, WayEnd end, double limit, Crossings to) {
        MeshProbe probe = new MeshProbe();
        Vec3 o = way.origin();
        Vec3 d = way.direction();
        to.clear();
        to.turnTo(0);
        for (int s = 0; tinters != null && s < tinters.length; s++) {
            if (tinters[s]) {
                primitives.crossings(s, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), end.touches(s, o), limit, probe, true, to);
            }
        }
    }

    /** Whether any primitive throws a shadow; where none does, rays must not be asked. */
    public boolean throwsShadows() {
        return throwsShadows;
    }

    private boolean casts(int primitive) {
        return casters == null || casters[primitive];
    }

    private int[] materialOf() {
        Map<String, Integer> index = new HashMap<>();
        names.forEach(name -> index.put(name, index.size()));
        return shapes.stream().mapToInt(s -> index.get(s.material())).toArray();
    }

    /** Whether the shapes of {@code other} are these, seen from this place; its materials may be others. */
    public boolean serves(Scene other) {
        return hasShapesOf(other) && scene.camera().origin().equals(other.camera().origin());
    }

    private boolean hasShapesOf(Scene other) {
        return scene.nodes().equals(other.nodes()) && hasWaysOf(other);
    }

    /**
     * Whether the materials that shapes have bend normals as those of another scene do, lead rays on behind them and throw shadows:
     * what is met is told with its normal and with where rays go on.
     */
    private boolean hasWaysOf(Scene other) {
        if (scene.materials() == other.materials()) {
            return true;
        }
        Map<String, Material> here = scene.materialsByName();
        Map<String, Material> there = other.materialsByName();
        return scene.stage().namedMaterials().stream().allMatch(m -> here.get(m).hasWaysOf(there.get(m)));
    }

    /** Whether these are the shapes of a scene, and an eye may stand at a point of it without their being moved. */
    public boolean servesEye(Scene other, Vec3 eye) {
        return hasShapesOf(other) && toRenderSpace(eye).maxAbs() <= primitives.farthest;
    }

    /** Where render space begins, a point of the scene. */
    public Vec3 origin() {
        return scene.camera().origin();
    }

    /**
     * What rays of another scene can meet: this itself where it serves that scene, its tree with moved boxes where shapes are
     * the same and the camera stands elsewhere, and else built anew.
     *
     * @param casting as for a new one
     */
    public Geometry forScene(Scene other, Predicate<Material> casting) {
        if (!hasShapesOf(other)) {
            return new Geometry(other, casting);
        }
        return serves(other) && mirrors == casting ? of(other) : new Geometry(this, other, casting);
    }

    /**
     * The same shapes with the materials of another scene, each at the same index as here.
     *
     * @throws IllegalArgumentException if this geometry does not serve that scene
     */
    public Geometry of(Scene other) {
        if (!serves(other)) {
            throw new IllegalArgumentException("the geometry is another scene's");
        }
        return scene.materials().equals(other.materials()) ? this : new Geometry(this, other);
    }

    /**
     * What becomes of these shapes where those of another scene follow, seen from the same place. Rows that know a material by its
     * index here know it by the same there.
     */
    public ShapeChange changeTo(Scene other) {
        ShapeChange known = change == null ? null : change.get();
        if (known == null || !known.after(this).hasShapesOf(other)) {
            known = new ShapeChange(this, new Geometry(other, this));
            change = new WeakReference<>(known);
        }
        return known;
    }

    /** The same where those shapes are known already, of a geometry that followed from this one, perhaps in several steps. */
    public ShapeChange changeTo(Geometry later) {
        return new ShapeChange(this, later);
    }

    /** Which materials cast mirrored rays. */
    public Predicate<Material> mirrors() {
        return mirrors;
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
    public int number(int primitive) {
        return HitCode.ofName(shape(primitive).name());
    }

    /** The shape that a primitive is of. */
    public Shape shape(int primitive) {
        return shapes.get(owner(primitive));
    }

    /** The material of a primitive. */
    public Material material(int primitive) {
        return materials.material(materialOf(primitive));
    }

    /** The index of the material of a primitive. */
    public int materialOf(int primitive) {
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
    public int nearestOfAll(Ray ray) {
        int nearest = -1;
        double least = Form.MISS;
        for (int s = 0; s < primitives.count; s++) {
            double t = distance(s, ray);
            if (t < least) {
                least = t;
                nearest = s;
            }
        }
        return nearest;
    }

    /** The same, where meshes are asked by their trees: these serve rays from anywhere, which the tree of primitives does not. */
    public int nearestInTurn(Ray ray) {
        return bvh.walk(ray).nearestInTurn();
    }

    /** The same by the tree of boxes; origins are the camera or lie within the box of the scene. */
    public int nearest(Ray ray) {
        return bvh.nearest(ray);
    }

    /** Whether any primitive is met at a distance below {@code limit}, by the tree of boxes. */
    public boolean blocked(Ray ray, double limit) {
        return bvh.blocked(ray, limit);
    }

    /** Whether any primitive that throws shadows is met at a distance below {@code limit}; every one is asked. */
    public boolean blockedByAny(Ray ray, double limit) {
        for (int s = 0; s < primitives.count; s++) {
            if (casts(s) && distance(s, ray) < limit) {
                return true;
            }
        }
        return false;
    }

    /** Where ways to a light at a point in render space end; every primitive is asked. */
    public WayEnd endOfAll(Vec3 point) {
        return WayEnd.ofAll(point, bvh);
    }

    /** The same by the tree of boxes. */
    public WayEnd end(Vec3 point) {
        return WayEnd.at(point, bvh);
    }

    /** Whether any primitive that throws shadows stands between a point and a light, both in render space; every one is asked. */
    public boolean blockedByAny(Vec3 point, WayEnd end) {
        Ray way = new Ray(point, end.point().minus(point));
        for (int s = 0; s < primitives.count; s++) {
            if (casts(s) && distance(s, way, end) < 1) {
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
    public int blocker(Vec3 point, WayEnd end) {
        return bvh.blocker(new Ray(point, end.point().minus(point)), end);
    }

    /** The distance along a ray to a primitive, or {@code +∞}. */
    public double distance(int primitive, Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return primitives.distance(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    }

    /** The distance along the way to a light, 1 at the light, to a primitive that comes between; {@code +∞} where it does not. */
    public double distance(int primitive, Ray way, WayEnd end) {
        Vec3 o = way.origin();
        Vec3 d = way.direction();
        return end.touches(primitive, o) ? primitives.distance(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), Touch.END)
                : distance(primitive, way);
    }

    /**
     * What a ray meets on a primitive; a mesh is asked by its tree.
     *
     * @throws IllegalArgumentException if the ray misses the primitive
     */
    public SurfacePoint surface(int primitive, Ray ray) {
        RayWalk walk = bvh.walk(ray);
        return walk.only(primitive) < 0 ? missed(primitive)
                : new SurfaceProbe(primitives, materials).at(primitive, walk.part(), ray, walk.distance());
    }

    /** The same; every triangle of a mesh is asked. */
    public SurfacePoint surfaceOfAll(int primitive, Ray ray) {
        double t = distance(primitive, ray);
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return t == Form.MISS ? missed(primitive)
                : new SurfaceProbe(primitives, materials).at(primitive,
                        primitives.part(primitive, o.x(), o.y(), o.z(), d.x(), d.y(), d.z()), ray, t);
    }

    /**
     * How the normal came about by which a ray's hit on a primitive is shaded; null where it is the surface's own.
     *
     * @throws IllegalArgumentException if the ray misses the primitive
     */
    public NormalSteps normalSteps(int primitive, Ray ray) {
        RayWalk walk = bvh.walk(ray);
        if (walk.only(primitive) < 0) {
            missed(primitive);
        }
        return new SurfaceProbe(primitives, materials).steps(primitive, walk.part(), ray, walk.distance());
    }

    private static SurfacePoint missed(int primitive) {
        throw new IllegalArgumentException("the ray misses primitive " + primitive);
    }
}

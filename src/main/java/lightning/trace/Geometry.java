package lightning.trace;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.math.Vec3;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;

/**
 * What rays can meet: a scene's shapes and materials in render space, without its lights.
 *
 * <p>Shapes and their tree of boxes are built once for all scenes that differ in lights and materials only, and the form
 * of the tree, which takes the time, for all cameras. Shared between threads.
 */
public final class Geometry {
    private final Scene scene;
    private final List<PlacedShape> placed;
    private final List<String> names;
    private final ShapeTable shapes;
    private final MaterialTable materials;
    private final Bvh bvh;
    private final boolean everyMirror;

    /** Prepares the shapes of a scene. */
    public Geometry(Scene scene) {
        this(scene, false);
    }

    /**
     * Prepares the shapes of a scene.
     *
     * @param everyMirror whether mirrored rays are cast from all of them, although most may mirror nothing
     */
    public Geometry(Scene scene, boolean everyMirror) {
        this.scene = scene;
        placed = scene.placedShapes();
        names = MaterialTable.names(placed);
        this.everyMirror = everyMirror;
        materials = new MaterialTable(names, scene, everyMirror);
        shapes = new ShapeTable(placed, materialOf(), scene.camera().from());
        bvh = new Bvh(shapes);
    }

    private Geometry(Geometry shared, Scene scene) {
        this.scene = scene;
        placed = shared.placed;
        names = shared.names;
        everyMirror = shared.everyMirror;
        materials = new MaterialTable(names, scene, everyMirror);
        shapes = shared.shapes;
        bvh = shared.bvh;
    }

    /** The form of the tree is another's. */
    private Geometry(Geometry shared, Scene scene, boolean everyMirror) {
        this.scene = scene;
        placed = shared.placed;
        names = shared.names;
        this.everyMirror = everyMirror;
        materials = new MaterialTable(names, scene, everyMirror);
        shapes = new ShapeTable(placed, shared.shapes.material, scene.camera().from());
        bvh = new Bvh(shapes, shared.bvh);
    }

    private int[] materialOf() {
        Map<String, Integer> index = new HashMap<>();
        names.forEach(name -> index.put(name, index.size()));
        return placed.stream().mapToInt(s -> index.get(s.shape().material())).toArray();
    }

    /** Whether the shapes of {@code other} are these, seen from this place; its materials may be others. */
    public boolean serves(Scene other) {
        return hasShapesOf(other) && scene.camera().from().equals(other.camera().from());
    }

    private boolean hasShapesOf(Scene other) {
        return scene.nodes().equals(other.nodes());
    }

    /**
     * What rays of another scene can meet: this itself where it serves that scene, its tree with moved boxes where shapes are
     * the same and the camera stands elsewhere, and else built anew.
     *
     * @param everyMirrors as for a new one
     */
    public Geometry forScene(Scene other, boolean everyMirrors) {
        if (!hasShapesOf(other)) {
            return new Geometry(other, everyMirrors);
        }
        return serves(other) && everyMirror == everyMirrors ? of(other) : new Geometry(this, other, everyMirrors);
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

    /** Whether mirrored rays are cast from all shapes. */
    public boolean everyMirror() {
        return everyMirror;
    }

    public MaterialTable materials() {
        return materials;
    }

    public int shapeCount() {
        return shapes.count;
    }

    /** The shape with the given index. */
    public PlacedShape shape(int index) {
        PlacedShape shape = placed.get(index);
        return new PlacedShape(shape.shape(), materials.material(shapes.material[index]), shape.toWorld(), shape.directionsBack(),
                shape.error());
    }

    /** The index of the material of the shape with the given index. */
    public int materialOf(int shape) {
        return shapes.material[shape];
    }

    ShapeTable shapes() {
        return shapes;
    }

    Bvh bvh() {
        return bvh;
    }

    /** Where a point of the scene lies in render space. */
    public Vec3 toRenderSpace(Vec3 world) {
        return world.minus(scene.camera().from());
    }

    /** Where a point of render space lies in the scene. */
    public Vec3 toScene(Vec3 render) {
        return render.plus(scene.camera().from());
    }

    /**
     * The shape that a ray meets first: every shape is asked, none is skipped.
     *
     * @return its index, or −1
     */
    public int nearestOfAll(Ray ray) {
        int nearest = -1;
        double least = Solids.MISS;
        for (int s = 0; s < shapes.count; s++) {
            double t = distance(s, ray);
            if (t < least) {
                least = t;
                nearest = s;
            }
        }
        return nearest;
    }

    /** The same by the tree of boxes; origins are the camera or lie within the box of the scene. */
    public int nearest(Ray ray) {
        return bvh.nearest(ray);
    }

    /** Whether any shape is met at a distance below {@code limit}, by the tree of boxes. */
    public boolean blocked(Ray ray, double limit) {
        return bvh.blocked(ray, limit);
    }

    /** Whether any shape is met at a distance below {@code limit}; every shape is asked. */
    public boolean blockedByAny(Ray ray, double limit) {
        for (int s = 0; s < shapes.count; s++) {
            if (distance(s, ray) < limit) {
                return true;
            }
        }
        return false;
    }

    /** Where ways to a light at a point in render space end. */
    public WayEnd end(Vec3 point) {
        return WayEnd.at(point, shapes);
    }

    /** Whether any shape stands between a point and a light, both in render space; every shape is asked. */
    public boolean blockedByAny(Vec3 point, WayEnd end) {
        Ray way = new Ray(point, end.point().minus(point));
        for (int s = 0; s < shapes.count; s++) {
            if (distance(s, way, end) < 1) {
                return true;
            }
        }
        return false;
    }

    /**
     * The shape that stands nearest to a point on its way to a light, both in render space; every shape is asked.
     *
     * @return its index, or −1 where the way is free
     */
    public int blocker(Vec3 point, WayEnd end) {
        Ray way = new Ray(point, end.point().minus(point));
        int nearest = -1;
        double least = 1;
        for (int s = 0; s < shapes.count; s++) {
            double t = distance(s, way, end);
            if (t < least) {
                least = t;
                nearest = s;
            }
        }
        return nearest;
    }

    /** The distance along a ray to a shape, or {@code +∞}. */
    public double distance(int shape, Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return shapes.distance(shape, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    }

    /** The distance along the way to a light, 1 at the light, to a shape that comes between; {@code +∞} where it does not. */
    private double distance(int shape, Ray way, WayEnd end) {
        Vec3 o = way.origin();
        Vec3 d = way.direction();
        return end.touches(shape, o) ? shapes.distance(shape, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), Touch.END) : distance(shape, way);
    }

    /**
     * What a ray meets on a shape.
     *
     * @throws IllegalArgumentException if the ray misses the shape
     */
    public SurfacePoint surface(int shape, Ray ray) {
        double t = distance(shape, ray);
        if (t == Solids.MISS) {
            throw new IllegalArgumentException("the ray misses shape " + shape);
        }
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        Surface surface = new Surface();
        surface.at(shapes, shape, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), t);
        int material = shapes.material[shape];
        float[] diffuse = {materials.diffuse(material, 0), materials.diffuse(material, 1), materials.diffuse(material, 2)};
        float[] texel = {1, 1, 1};
        if (materials.isTextured(material)) {
            TextureLookup.sample(materials.texture(material), shapes.kind[shape], surface.ownX, surface.ownY, surface.ownZ, texel);
            for (int c = 0; c < 3; c++) {
                diffuse[c] *= texel[c];
            }
        }
        return new SurfacePoint(shape, material, surface.px, surface.py, surface.pz, surface.nx, surface.ny, surface.nz,
                (float) d.x(), (float) d.y(), (float) d.z(), diffuse, texel);
    }
}

package lightning.render.trace.primitive;

import java.util.Arrays;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.mesh.MeshProbe;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.Sieve;
import lightning.render.trace.solid.Form;
import lightning.render.trace.solid.Kind;
import lightning.render.trace.solid.Touch;
import lightning.scene.Cutout;
import lightning.scene.Material;
import lightning.scene.PlacedShape;
import lightning.scene.Relief;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;

/**
 * All that rays of a scene can meet, as plain columns, in render space.
 *
 * <p>Primitive {@code s} is a canonical solid of kind {@link #kind} or a {@link #mesh}, a part of the shape with index
 * {@code owner[s]}, of material index {@code material[s]}. Its data begin at {@code data[at[s]]}, as {@link Form} has them: the map
 * from render space to its own space, and numbers of its own. What is met of a mesh is one of its triangles, the <em>part</em> of a
 * hit; of a solid it is 0.
 */
public final class PrimitiveTable {
    /** The error of a way to a light as a share of the coordinates of its ends ({@link #off}). */
    public static final double WAY = 0x1p-47;

    public final int count;
    public final int[] owner;
    public final int[] material;
    public final int[] at;
    public final double[] data;
    /** A bound on the error of a hit point on the primitive that its distance from the camera causes, scene units. */
    public final double[] error;
    /** Where the primitives stand. Placed shapes are made anew for each camera: kept, each would take 112 bytes. */
    public final Stage stage;

    /** The ordinal of each solid's kind; {@link #MESH} for a mesh. */
    private final byte[] kind;
    /** The mesh of each primitive that is one; null where none is. */
    private final MeshSolid[] meshes;
    private final SurfaceTraits traits;
    /** How far a point that was put on the primitive may lie off it because shape and camera are rounded, scene units. */
    private final double[] off;
    /** Whether the eye lies on the primitive. */
    private final boolean[] underEye;
    /** How far the primitive reaches from its place, scene units along an axis. */
    private final double[] size;
    /** The largest coordinate of a primitive, render space: rays may start within it. */
    public final double farthest;
    /** More than the |x| + |y| + |z| of any point of a primitive. */
    public final double reach;
    /** The most that a point put on any primitive may lie off it because shape and camera are rounded, scene units. */
    private final double mostOff;

    private static final byte MESH = -1;

    /**
     * Primitives with their boxes, which the tree keeps.
     *
     * @param boxes as {@link PrimitiveBoxes} makes them
     */
    public record Boxed(PrimitiveTable primitives, float[] boxes) {}

    /** Writes to {@code bounds}, {@code slack} and {@code share} what {@link PrimitiveBoxes} wants. */
    private PrimitiveTable(byte[] kind, MeshSolid[] meshes, SurfaceTraits traits, int[] material, int[] owner, int[] at, double[] data,
            Stage stage, Vec3 camera, double[] bounds, double[] slack, double[] share) {
        count = kind.length;
        this.kind = kind;
        this.meshes = meshes;
        this.traits = traits;
        this.material = material;
        this.owner = owner;
        this.at = at;
        this.data = data;
        this.stage = stage;
        error = new double[count];
        off = new double[count];
        size = new double[count];
        underEye = new boolean[count];
        double[] extremes = new double[2];
        int[] next = {0};
        stage.place(shape -> {
            int s = next[0]++;
            var map = new PlacedMap(shape, camera);
            Transform render = map.render;
            map.storeInverse(data, at[s]);
            extent(s, render.m00(), render.m01(), render.m02(), render.t0(), bounds, 6 * s);
            extent(s, render.m10(), render.m11(), render.m12(), render.t1(), bounds, 6 * s + 1);
            extent(s, render.m20(), render.m21(), render.m22(), render.t2(), bounds, 6 * s + 2);
            double far = 0;
            for (int i = 6 * s; i < 6 * s + 6; i++) {
                far = Math.max(far, Math.abs(bounds[i]));
            }
            error[s] = far * Surface.ERROR;
            slack[s] = Slack.of(render, map.inverse, far);
            share[s] = mesh(s) == null ? Slack.share(render, map.inverse, kind(s).form().tip(data, at[s])) : 0;
            extremes[0] = Math.max(extremes[0], far);
            off(s, shape, map, bounds, camera);
            underEye[s] = gap(s, 0, 0, 0) <= off[s];
            extremes[1] = Math.max(extremes[1], off[s]);
        });
        farthest = extremes[0];
        reach = 4 * farthest;
        mostOff = extremes[1];
    }

    /** @param material the material index of each shape */
    public static Boxed of(Stage stage, int[] material, Vec3 camera) {
        List<Shape> shapes = stage.shapes();
        int count = shapes.size();
        byte[] kind = new byte[count];
        int[] owner = new int[count];
        int[] at = new int[count];
        MeshSolid[] meshes = null;
        int numbers = 0;
        for (int s = 0; s < count; s++) {
            owner[s] = s;
            at[s] = numbers;
            switch (shapes.get(s).solid()) {
                case Solid.Canonical solid -> {
                    kind[s] = (byte) Kind.of(solid).ordinal();
                    numbers += Form.MAP + Kind.numbers(solid).length;
                }
                case Solid.Triangles triangles -> {
                    kind[s] = MESH;
                    meshes = meshes == null ? new MeshSolid[count] : meshes;
                    meshes[s] = new MeshSolid(triangles.mesh());
                    numbers += Form.MAP;
                }
            }
        }
        double[] data = new double[numbers];
        for (int s = 0; s < count; s++) {
            if (shapes.get(s).solid() instanceof Solid.Canonical solid) {
                double[] own = Kind.numbers(solid);
                System.arraycopy(own, 0, data, at[s] + Form.MAP, own.length);
            }
        }
        return boxed(kind, meshes, new SurfaceTraits(stage), material, owner, at, data, stage, camera);
    }

    private static Boxed boxed(byte[] kind, MeshSolid[] meshes, SurfaceTraits traits, int[] material, int[] owner, int[] at, double[] data,
            Stage stage, Vec3 camera) {
        double[] bounds = new double[6 * kind.length];
        double[] slack = new double[kind.length];
        double[] share = new double[kind.length];
        PrimitiveTable table = new PrimitiveTable(kind, meshes, traits, material, owner, at, data, stage, camera, bounds, slack, share);
        return new Boxed(table, PrimitiveBoxes.of(bounds, slack, share));
    }

    /**
     * Whether all that rays read of primitive {@code s} has the same bits as what they read of primitive {@code t} of another table
     * in the same render space; materials may differ, normals that are bent, and what passes through.
     */
    public boolean isAlike(int s, PrimitiveTable o, int t) {
        return kind[s] == o.kind[t] && (kind[s] != MESH || mesh(s).mesh() == o.mesh(t).mesh())
                && Arrays.equals(data, at[s], end(s), o.data, o.at[t], o.end(t)) && error[s] == o.error[t] && off[s] == o.off[t]
                && size[s] == o.size[t] && underEye[s] == o.underEye[t] && traits.hasHolesOf(s, o.traits, t);
    }

    private int end(int s) {
        return s + 1 < count ? at[s + 1] : data.length;
    }

    /** The same primitives seen from elsewhere. */
    public Boxed from(Vec3 camera) {
        return boxed(kind, meshes, traits, material, owner, at, data.clone(), stage, camera);
    }

    /**
     * The bound on how far a point x that was put on the shape lies off the surface that rays meet, scene units.
     *
     * <p>Its own point is B·(x − place). A number of B is off by what {@code PlacementError} tells, times a distance within the
     * shape; the place by the same. Maximum norms, u = 2⁻⁵³: x and the camera are decimals made doubles and subtracted, u·(2|x|
     * + |camera|), the place u·|place|; mapping takes 4u·|x| + 4u·|place|, and for the eye, x = 0, only 3u·|place|. For the eye that
     * is all, with 4u in own units for the surface's formula, where 1 is no more than the shape's size in the scene.
     *
     * <p>A way from p to a light at x has errors of its own: 6u·|x| + u·|place| are left from above; 13u·|p| + 8u·|place| + 5u·|x| in
     * its map, and 8 units in the last place of its length in what its {@link Form} finds, 16u·(|p| + |place|) and 16u in own units.
     * As |place| ≤ |x| + size, all of it is less than 64u of |x|, |p| and the size.
     */
    private void off(int s, PlacedShape shape, PlacedMap map, double[] bounds, Vec3 camera) {
        int b = 6 * s;
        Vec3 place = map.place;
        size[s] = Math.max(new Vec3(bounds[b], bounds[b + 1], bounds[b + 2]).minus(place).maxAbs(),
                new Vec3(bounds[b + 3], bounds[b + 4], bounds[b + 5]).minus(place).maxAbs());
        off[s] = map.turned() * size[s] + shape.error().place() + 0x1p-51 * (size[s] + place.maxAbs() + camera.maxAbs());
    }

    /**
     * How far a light that was put on a primitive may lie off it, scene units.
     *
     * @param far the sum of |x| + |y| + |z| at both ends of a way to it, render space
     */
    public double offLight(int s, double far) {
        return off[s] + WAY * (size[s] + far);
    }

    /** No less than that of any primitive: none reaches farther from its place than {@link #reach}, and rounding keeps order. */
    public double offLight(double far) {
        return mostOff + WAY * (reach + far);
    }

    /** How far the eye may lie off a primitive on which it was put, scene units. */
    public double offEye(int s) {
        return off[s];
    }

    private void extent(int s, double mx, double my, double mz, double t, double[] bounds, int i) {
        MeshSolid mesh = mesh(s);
        if (mesh == null) {
            kind(s).form().extent(data, at[s], mx, my, mz, t, bounds, i);
        } else {
            mesh.extent(mx, my, mz, t, bounds, i);
        }
    }

    /** Whether any primitive is a mesh. */
    public boolean hasMeshes() {
        return meshes != null;
    }

    /** The mesh that primitive {@code s} is; null where it is a canonical solid. */
    public MeshSolid mesh(int s) {
        return meshes == null ? null : meshes[s];
    }

    /** How long a step of at most 1 along each axis of the scene can be in its own units. */
    public double rate(int s) {
        double[] m = data;
        int i = at[s];
        return new Vec3(Math.abs(m[i]) + Math.abs(m[i + 1]) + Math.abs(m[i + 2]),
                Math.abs(m[i + 4]) + Math.abs(m[i + 5]) + Math.abs(m[i + 6]),
                Math.abs(m[i + 8]) + Math.abs(m[i + 9]) + Math.abs(m[i + 10])).length();
    }

    /**
     * How far a point in render space lies off the surface of a primitive at least, scene units: from the patch on each axis
     * by itself; from a solid by its own distance, which changes by no more than a point moves, over how long a step of the
     * scene can be in it.
     */
    public double gap(int s, double x, double y, double z) {
        double[] m = data;
        int i = at[s];
        double px = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
        double py = m[i + 4] * x + m[i + 5] * y + m[i + 6] * z + m[i + 7];
        double pz = m[i + 8] * x + m[i + 9] * y + m[i + 10] * z + m[i + 11];
        MeshSolid mesh = mesh(s);
        return mesh == null ? kind(s).form().gap(m, i, px, py, pz, rate(s)) : mesh.gap(px, py, pz) / rate(s);
    }

    /** Whether rays may pass any primitive where they meet it. */
    public boolean haveHoles() {
        return traits.haveCutouts();
    }

    /** Whether rays may pass primitive {@code s} where they meet it. */
    public boolean hasHoles(int s) {
        return cutout(s) != null;
    }

    Cutout cutout(int s) {
        return traits.cutout(s);
    }

    /** Where a ray finds holes in primitive {@code s}, which has some. */
    private Holes holes(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        return new Holes(this).enter(s, ox, oy, oz, dx, dy, dz);
    }

    /** What bends the normals of primitive {@code s}; null for nothing. */
    public Relief relief(int s) {
        return traits.relief(s);
    }

    /** Whether rays go on behind primitive {@code s} as they do behind primitive {@code t} of another table. */
    public boolean leadsRaysAs(int s, PrimitiveTable o, int t) {
        return traits.leadsRaysAs(s, o.traits, t);
    }

    /** Whether normals of primitive {@code s} are bent as those of primitive {@code t} of another table. */
    public boolean isBentAs(int s, PrimitiveTable o, int t) {
        return traits.isBentAs(s, o.traits, t);
    }

    /** Whether primitive {@code s} shows colours of its vertices. */
    public boolean isTinted(int s) {
        return meshes != null && stage.shapes().get(owner[s]).solid() instanceof Solid.Triangles triangles && triangles.isTinted();
    }

    /** The kind of a canonical solid. */
    public Kind kind(int s) {
        return Kind.at(kind[s]);
    }

    /** Whether the eye lies on primitive {@code s}: it then does not hide from the eye what is before it. */
    public boolean isUnderEye(int s) {
        return underEye[s];
    }

    /** The distance along the ray to primitive {@code s}, or {@code +∞}; a ray from the origin of render space is the eye's. */
    public double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(s, ox, oy, oz, dx, dy, dz, touch(s, ox, oy, oz));
    }

    private Touch touch(int s, double ox, double oy, double oz) {
        return underEye[s] && ox == 0 && oy == 0 && oz == 0 ? Touch.START : Touch.NEITHER;
    }

    /** Hands a mesh and a ray, which is the eye's where it begins at the origin of render space, to a probe. */
    public void enter(MeshProbe probe, int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        enter(probe, s, ox, oy, oz, dx, dy, dz, touch(s, ox, oy, oz));
    }

    /** The same for a way that perhaps ends on the mesh. */
    public void enter(MeshProbe probe, int s, double ox, double oy, double oz, double dx, double dy, double dz, boolean ends) {
        enter(probe, s, ox, oy, oz, dx, dy, dz, ends ? Touch.END : touch(s, ox, oy, oz));
    }

    /** The same for a way of which an end may lie on the mesh: it passes the triangles on which it may. */
    public void enter(MeshProbe probe, int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch) {
        enter(probe, s, ox, oy, oz, dx, dy, dz, touch, cutout(s) == null ? null : holes(s, ox, oy, oz, dx, dy, dz));
    }

    /** The same through a sieve; null for none. */
    private void enter(MeshProbe probe, int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch,
            Sieve sieve) {
        double[] m = data;
        int i = at[s];
        double px = m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3];
        double py = m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7];
        double pz = m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11];
        double vx = m[i] * dx + m[i + 1] * dy + m[i + 2] * dz;
        double vy = m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz;
        double vz = m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz;
        probe.enter(meshes[s], px, py, pz, vx, vy, vz);
        if (sieve != null) {
            probe.sift(sieve);
        }
        switch (touch) {
            case NEITHER -> {}
            case START -> probe.pass(px, py, pz, rate(s) * offEye(s));
            case END -> probe.pass(px + vx, py + vy, pz + vz, rate(s) * offLight(s, far(ox, oy, oz, dx, dy, dz)));
        }
    }

    /** The sum of |x| + |y| + |z| at both ends of a way. */
    private static double far(double ox, double oy, double oz, double dx, double dy, double dz) {
        return Math.abs(ox + dx) + Math.abs(oy + dy) + Math.abs(oz + dz) + Math.abs(ox) + Math.abs(oy) + Math.abs(oz);
    }

    /** Asks all triangles of mesh {@code s}. */
    private double distanceOfAll(int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch) {
        MeshProbe probe = new MeshProbe();
        enter(probe, s, ox, oy, oz, dx, dy, dz, touch);
        return probe.nearestOfAll();
    }

    /** The part of primitive {@code s} that a ray meets first; the primitive is met. */
    public int part(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        if (mesh(s) == null) {
            return 0;
        }
        MeshProbe probe = new MeshProbe();
        enter(probe, s, ox, oy, oz, dx, dy, dz);
        probe.nearestOfAll();
        return probe.triangle();
    }

    /** The distance along a way of which an end may lie on primitive {@code s}, or {@code +∞}; every triangle of a mesh is asked. */
    public double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch) {
        if (mesh(s) != null) {
            return distanceOfAll(s, ox, oy, oz, dx, dy, dz, touch);
        }
        double t = whole(s, ox, oy, oz, dx, dy, dz, touch);
        if (t == Form.MISS || cutout(s) == null) {
            return t;
        }
        return there(s, ox, oy, oz, dx, dy, dz, touch, t, Form.MISS, holes(s, ox, oy, oz, dx, dy, dz));
    }

    /**
     * The distance to what is there first of a solid with holes, which a ray that neither begins nor ends on it meets at {@code t} if nothing is
     * missing; {@code +∞} where nothing is there, and perhaps where it lies beyond a limit.
     *
     * @param holes scratch
     */
    public double there(int s, double ox, double oy, double oz, double dx, double dy, double dz, double t, double limit, Holes holes) {
        return there(s, ox, oy, oz, dx, dy, dz, Touch.NEITHER, t, limit, holes.enter(s, ox, oy, oz, dx, dy, dz));
    }

    private double there(int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch, double t, double limit,
            Holes holes) {
        if (!holes.passes(0, t)) {
            return t;
        }
        double out = last(s, ox, oy, oz, dx, dy, dz, touch, t);
        return out < Form.MISS && out <= limit && !holes.passes(0, out) ? out : Form.MISS;
    }

    /** The distance to a surface without holes. */
    private double whole(int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch) {
        double off = switch (touch) {
            case NEITHER -> 0;
            case START -> offEye(s);
            case END -> offLight(s, far(ox, oy, oz, dx, dy, dz));
        };
        return whole(s, ox, oy, oz, dx, dy, dz, touch, off);
    }

    /** The same where the end that lies on the surface is off it by so much, in scene space. */
    private double whole(int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch, double off) {
        double[] m = data;
        int i = at[s];
        double px = m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3];
        double py = m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7];
        double pz = m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11];
        double vx = m[i] * dx + m[i + 1] * dy + m[i + 2] * dz;
        double vy = m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz;
        double vz = m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz;
        Form form = kind(s).form();
        if (touch == Touch.NEITHER) {
            return form.distance(m, i, px, py, pz, vx, vy, vz);
        }
        double margin = off == 0 ? 0 : 2 * form.tip(m, i) * rate(s) * off / Math.sqrt(vx * vx + vy * vy + vz * vz);
        return form.distance(m, i, px, py, pz, vx, vy, vz, touch, margin);
    }

    /** The distance to where a ray that met a convex surface at {@code t} meets it once more, or {@code +∞}. */
    private double last(int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch, double t) {
        double out = touch == Touch.NEITHER ? whole(s, ox, oy, oz, dx, dy, dz, Touch.START, 0) : Form.MISS;
        return out > t ? out : Form.MISS;
    }

    /** Whether light on its way to a point passes any primitive. */
    public boolean haveTints() {
        return traits.haveTints();
    }

    /** The material of primitive {@code s} where light on its way to a point passes it; else null. */
    public Material tint(int s) {
        return traits.tint(s);
    }

    /** Whether light passes primitive {@code s} as it passes primitive {@code t} of another table. */
    public boolean passesLightAs(int s, PrimitiveTable o, int t) {
        return traits.passesLightAs(s, o.traits, t);
    }

    /**
     * Adds all places where a way meets primitive {@code s} before a distance.
     *
     * @param ends  whether it ends on the primitive
     * @param probe for meshes
     * @param every whether each triangle of a mesh is asked
     */
    public void crossings(int s, double ox, double oy, double oz, double dx, double dy, double dz, boolean ends, double limit,
            MeshProbe probe, boolean every, Crossings to) {
        Touch touch = ends ? Touch.END : touch(s, ox, oy, oz);
        Holes holes = cutout(s) == null ? null : holes(s, ox, oy, oz, dx, dy, dz);
        if (mesh(s) != null) {
            // What is passed is noted, and all is.
            enter(probe, s, ox, oy, oz, dx, dy, dz, touch, (triangle, t) -> {
                to.add(s, triangle, t, limit, holes);
                return true;
            });
            if (every) {
                probe.nearestOfAll();
            } else {
                probe.blocked(limit);
            }
            return;
        }
        double t = whole(s, ox, oy, oz, dx, dy, dz, touch);
        if (t < Form.MISS) {
            to.add(s, 0, t, limit, holes);
            to.add(s, 0, last(s, ox, oy, oz, dx, dy, dz, touch, t), limit, holes);
        }
    }

    /** The same for a solid without holes, which a way that neither begins nor ends on it is known to meet first at {@code t}. */
    public void crossings(int s, double ox, double oy, double oz, double dx, double dy, double dz, double t, double limit, Crossings to) {
        to.add(s, 0, t, limit, null);
        to.add(s, 0, last(s, ox, oy, oz, dx, dy, dz, Touch.NEITHER, t), limit, null);
    }
}

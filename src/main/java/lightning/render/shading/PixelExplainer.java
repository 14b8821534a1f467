package lightning.render.shading;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Eye;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.tree.WayEnd;
import lightning.scene.Cutout;
import lightning.scene.Scene;

/** Traces single pixels and tells why they have their colour; the colour is the film's in every bit. */
public final class PixelExplainer {
    private static final float[] NONE = {0, 0, 0};
    private static final float[] ALL = {1, 1, 1};

    private final Scene scene;
    private final Geometry geometry;
    private final MaterialTable materials;
    private final Geometry whole;
    private final List<Luminaire> lights;

    /** Where ways to lights end, by the place of a light. */
    private final Map<Vec3, WayEnd> ends;

    /** Tells the holes that rays pass, too, for which it builds a second tree. */
    public PixelExplainer(Scene scene) {
        this(scene, new Geometry(scene), new HashMap<>(), whole(scene));
    }

    /** @param known a geometry that serves the scene, as a picture of it was traced with */
    public PixelExplainer(Scene scene, Geometry known) {
        this(scene, known.forScene(scene, known.mirrors()), new HashMap<>(), null);
    }

    private PixelExplainer(Scene scene, Geometry geometry, Map<Vec3, WayEnd> ends, Geometry whole) {
        this.scene = scene;
        this.geometry = geometry;
        this.ends = ends;
        materials = geometry.materials();
        this.whole = whole;
        lights = scene.rig().actingLights().stream().map(light -> Luminaire.of(light, scene)).toList();
    }

    /** The explainer of another scene, which shares with this one what it knows of the shapes. */
    public PixelExplainer forScene(Scene other, Geometry known) {
        boolean same = geometry.serves(other);
        return new PixelExplainer(other, (same ? geometry : known).forScene(other, known.mirrors()), same ? ends : new HashMap<>(), null);
    }

    /** The shapes and materials that the reports point to. */
    public Geometry geometry() {
        return geometry;
    }

    /** Everything about the pixel in column {@code x} from the left and row {@code y} from the top. */
    public PointReport pixel(int x, int y) {
        return ray(new Eye(scene).through(x, y), scene.picture().depth());
    }

    private PointReport ray(Ray ray, int depth) {
        int shape = geometry.nearest(ray);
        if (shape < 0) {
            return new PointReport(null, holes(ray, Double.POSITIVE_INFINITY), null, Backdrop.color(scene.world(), ray.direction()), NONE,
                    List.of(), null, null);
        }
        SurfacePoint at = geometry.surface(shape, ray);
        NormalSteps normals = geometry.normalSteps(shape, ray);
        PointReport reflected = materials.isReflective(at.material()) && depth > 0 ? ray(at.mirrored(), depth - 1) : null;
        Ray through = materials.isClear(at.material()) && depth > 0 ? at.refracted() : null;
        PointReport refracted = through == null ? null : ray(through, depth - 1);
        List<LightReport> reports = new ArrayList<>();
        for (Luminaire light : lights) {
            reports.add(report(light, at, normals));
        }
        float[] color = new float[3];
        float[] ambient = new float[3];
        float ambience = (float) scene.world().ambience();
        var share = new SurfaceShare(at);
        for (int c = 0; c < 3; c++) {
            float ka = materials.ambient(at.material(), c);
            float kr = materials.reflective(at.material(), c);
            ambient[c] = ka * ambience * share.body(kr, c);
            color[c] = materials.isClear(at.material())
                    ? share.color(c, ka, ambience, at.diffuse()[c], sum(reports, c, LightReport::diffuse),
                            at.specular()[c], sum(reports, c, LightReport::highlight), sum(reports, c, LightReport::sheen), kr,
                            reflected == null ? 0 : reflected.color()[c], refracted == null ? 0 : refracted.color()[c])
                    : LightingEquation.color(ka, ambience, at.diffuse()[c], sum(reports, c, LightReport::diffuse),
                            at.specular()[c], sum(reports, c, LightReport::highlight), sum(reports, c, LightReport::sheen), kr,
                            reflected == null ? 0 : reflected.color()[c]);
        }
        return new PointReport(at, holes(ray, geometry.distance(shape, ray)), normals, color, ambient, reports, reflected, refracted);
    }

    /** The primitives that the ray would meet before a distance if nothing were cut out of them. */
    private List<Integer> holes(Ray ray, double before) {
        return whole == null ? List.of() : IntStream.range(0, whole.primitiveCount())
                .filter(s -> whole.material(s).cutout() != geometry.material(s).cutout() && whole.distance(s, ray) < before)
                .filter(s -> whole.distance(s, ray) < geometry.distance(s, ray)).boxed().toList();
    }

    /** The same shapes with nothing cut out of them; null where nothing is. */
    private static Geometry whole(Scene scene) {
        return scene.materials().stream().noneMatch(m -> m.cutout().cuts()) ? null : new Geometry(
                scene.withMaterials(scene.materials().stream().map(m -> m.cutout().cuts() ? m.withCutout(Cutout.NONE) : m).toList()));
    }

    private static float sum(List<LightReport> lights, int channel, Function<LightReport, float[]> part) {
        float[] terms = new float[lights.size()];
        for (int l = 0; l < terms.length; l++) {
            terms[l] = part.apply(lights.get(l))[channel];
        }
        return LightingEquation.sum(terms, 0, terms.length);
    }

    private LightReport report(Luminaire light, SurfacePoint at, NormalSteps normals) {
        return light.lamp().isArea() && !light.isDark() ? area(light, at, normals) : report(light, light.lamp(), at, normals);
    }

    /** The means of a light's samples; of those that do not reach the point, the one that comes farthest tells why. */
    private LightReport area(Luminaire light, SurfacePoint at, NormalSteps normals) {
        int samples = light.lamp().area().samples();
        double diffuse = 0;
        double specular = 0;
        double grazing = 0;
        int seen = 0;
        int below = 0;
        LightReport farthest = null;
        LightReport blocked = null;
        double[] tints = new double[3];
        int free = 0;
        for (int s = 0; s < samples; s++) {
            LightReport one = report(light, light.lamp().sample(LampArea.turn(at.px(), at.py(), at.pz()), s), at, normals);
            // A way counts wherever the cone ends, as in rows, which are not asked again when it moves.
            Lamp sample = light.lamp().sample(LampArea.turn(at.px(), at.py(), at.pz()), s);
            if (one.state() != LightReport.State.AWAY && (one.state() == LightReport.State.LIT || blocker(sample, at) < 0)) {
                float[] passed = tint(sample, at);
                for (int c = 0; c < 3; c++) {
                    tints[c] += passed[c];
                }
                free++;
            }
            diffuse += (double) one.falloff() * (one.state() == LightReport.State.LIT ? one.cosine() : 0);
            specular += (double) one.specular() * one.falloff();
            grazing += (double) one.grazing() * one.falloff();
            seen += one.state() == LightReport.State.LIT ? 1 : 0;
            below += one.below();
            farthest = farthest == null || one.state().compareTo(farthest.state()) > 0 ? one : farthest;
            blocked = blocked == null && one.state() == LightReport.State.SHADOWED ? one : blocked;
        }
        float cosine = LightingEquation.mean(diffuse, samples);
        float highlight = LightingEquation.mean(specular, samples);
        float sheen = LightingEquation.mean(grazing, samples);
        float[] tint = free == 0 ? ALL : new float[] {LightingEquation.mean(tints[0], free), LightingEquation.mean(tints[1], free),
            LightingEquation.mean(tints[2], free)};
        return new LightReport(light.light(), farthest.state(), blocked == null ? -1 : blocked.blocker(), seen, samples, below,
                seen == 0 ? farthest.cosine() : cosine, highlight, sheen, seen == 0 ? 0 : 1, contribution(light, cosine, 1, tint),
                contribution(light, highlight, 1, tint), contribution(light, sheen, 1, tint), tint);
    }

    private LightReport report(Luminaire light, Lamp lamp, SurfacePoint at, NormalSteps normals) {
        var equation = new LightingEquation(lamp);
        equation.at(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
        float cosine = equation.cosine(at.nx(), at.ny(), at.nz());
        int below = cosine > 0 && normals != null && !light.isDark() && !(cosine(equation, normals.surface()) > 0) ? 1 : 0;
        int blocker = -1;
        LightReport.State state;
        if (light.isDark()) {
            state = LightReport.State.DARK;
        } else if (!(cosine > 0)) {
            state = LightReport.State.AWAY;
        } else if (!equation.insideCone()) {
            state = LightReport.State.OUTSIDE;
        } else if (!geometry.linked(light.light().illuminates())[at.primitive()]) {
            state = LightReport.State.UNLINKED;
        } else {
            blocker = blocker(lamp, at);
            state = blocker < 0 ? LightReport.State.LIT : LightReport.State.SHADOWED;
        }
        if (state != LightReport.State.LIT) {
            return new LightReport(light.light(), state, blocker, 0, 1, below, cosine, 0, 0, 0, NONE, NONE, NONE, ALL);
        }
        boolean metallic = materials.isMetallic(at.material());
        double alpha = materials.alpha(at.material());
        float diffuse = metallic ? equation.matte(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz()) : cosine;
        float specular = metallic ? equation.gloss(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), alpha)
                : equation.specular(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), materials.shininess(at.material()));
        float grazing = metallic ? equation.grazing(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), alpha) : 0;
        float falloff = equation.falloff();
        float[] tint = tint(lamp, at);
        return new LightReport(light.light(), state, blocker, 1, 1, below, diffuse, specular, grazing, falloff,
                contribution(light, diffuse, falloff, tint), contribution(light, specular, falloff, tint),
                contribution(light, grazing, falloff, tint), tint);
    }

    private static float cosine(LightingEquation equation, Vec3 normal) {
        return equation.cosine((float) normal.x(), (float) normal.y(), (float) normal.z());
    }

    private static float[] contribution(Luminaire light, float term, float falloff, float[] tint) {
        return new float[] {
            LightingEquation.contribution(light.red(), term, falloff, tint[0]),
            LightingEquation.contribution(light.green(), term, falloff, tint[1]),
            LightingEquation.contribution(light.blue(), term, falloff, tint[2])};
    }

    /** What passes of a light on its free way to a point, red, green and blue. */
    private float[] tint(Lamp lamp, SurfacePoint at) {
        WayEnd end = lamp.type().hasPosition() ? ends.computeIfAbsent(lamp.source(), geometry::end) : WayEnd.OPEN;
        return Transmittance.onWay(geometry, lamp, end, at);
    }

    /** The shape between the point and the light that is nearest to the point, or −1. */
    private int blocker(Lamp lamp, SurfacePoint at) {
        Vec3 point = new Vec3(at.px(), at.py(), at.pz());
        Geometry casting = geometry.casting(lamp.light().shadowedBy());
        if (!casting.throwsShadows()) {
            return -1;
        }
        if (!lamp.type().hasPosition()) {
            return casting.nearest(new Ray(point, lamp.source()));
        }
        return casting.blocker(point, ends.computeIfAbsent(lamp.source(), geometry::end));
    }
}

package lightning.shading;

import java.util.ArrayList;
import java.util.List;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Scene;
import lightning.trace.Eye;
import lightning.trace.Geometry;
import lightning.trace.MaterialTable;
import lightning.trace.Ray;
import lightning.trace.SurfacePoint;

/** Traces single pixels and tells why they have their colour; the colour is the film's in every bit. */
public final class PixelExplainer {
    private static final float[] NONE = {0, 0, 0};

    private final Scene scene;
    private final Geometry geometry;
    private final MaterialTable materials;
    private final List<Lamp> lamps;

    public PixelExplainer(Scene scene) {
        this.scene = scene;
        geometry = new Geometry(scene);
        materials = geometry.materials();
        lamps = scene.lights().stream().map(light -> Lamp.of(light, scene)).toList();
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
        int shape = geometry.nearestOfAll(ray);
        if (shape < 0) {
            Rgb background = scene.world().background();
            float[] color = {(float) background.r(), (float) background.g(), (float) background.b()};
            return new PointReport(null, color, NONE, List.of(), null);
        }
        SurfacePoint at = geometry.surface(shape, ray);
        PointReport reflected = materials.isReflective(at.material()) && depth > 0 ? ray(at.mirrored(), depth - 1) : null;
        List<LightReport> lights = new ArrayList<>();
        for (Lamp lamp : lamps) {
            lights.add(light(lamp, at));
        }
        float[] color = new float[3];
        float[] ambient = new float[3];
        float ambience = (float) scene.world().ambience();
        for (int c = 0; c < 3; c++) {
            float ka = materials.ambient(at.material(), c);
            float kr = materials.reflective(at.material(), c);
            ambient[c] = ka * ambience * (1 - kr);
            color[c] = LightingEquation.color(ka, ambience, at.diffuse()[c], sum(lights, c, true),
                    materials.specular(at.material(), c), sum(lights, c, false), kr, reflected == null ? 0 : reflected.color()[c]);
        }
        return new PointReport(at, color, ambient, lights, reflected);
    }

    private static float sum(List<LightReport> lights, int channel, boolean diffuse) {
        float[] terms = new float[lights.size()];
        for (int l = 0; l < terms.length; l++) {
            terms[l] = (diffuse ? lights.get(l).diffuse() : lights.get(l).highlight())[channel];
        }
        return LightingEquation.sum(terms, 0, terms.length);
    }

    private LightReport light(Lamp lamp, SurfacePoint at) {
        var equation = new LightingEquation(lamp);
        equation.at(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
        float cosine = equation.cosine(at.nx(), at.ny(), at.nz());
        int blocker = -1;
        LightReport.State state;
        if (lamp.isDark()) {
            state = LightReport.State.DARK;
        } else if (!(cosine > 0)) {
            state = LightReport.State.AWAY;
        } else if (!equation.insideCone()) {
            state = LightReport.State.OUTSIDE;
        } else {
            blocker = blocker(lamp, at);
            state = blocker < 0 ? LightReport.State.LIT : LightReport.State.SHADOWED;
        }
        if (state != LightReport.State.LIT) {
            return new LightReport(lamp.light(), state, blocker, cosine, 0, 0, NONE, NONE);
        }
        float specular = equation.specular(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), materials.shininess(at.material()));
        float falloff = equation.falloff();
        return new LightReport(lamp.light(), state, blocker, cosine, specular, falloff,
                contribution(lamp, cosine, falloff), contribution(lamp, specular, falloff));
    }

    private static float[] contribution(Lamp lamp, float term, float falloff) {
        return new float[] {
            LightingEquation.contribution(lamp.red(), term, falloff),
            LightingEquation.contribution(lamp.green(), term, falloff),
            LightingEquation.contribution(lamp.blue(), term, falloff)};
    }

    /** The shape between the point and the light that is nearest to the point, or −1. */
    private int blocker(Lamp lamp, SurfacePoint at) {
        Vec3 point = new Vec3(at.px(), at.py(), at.pz());
        return lamp.type().hasPosition() ? geometry.blocker(point, geometry.end(lamp.source()))
                : geometry.nearestOfAll(new Ray(point, lamp.source()));
    }
}

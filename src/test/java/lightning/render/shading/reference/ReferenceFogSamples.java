package lightning.render.shading.reference;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogPath;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Scene;
import lightning.scene.value.Fog;

/** Light of the samples of fog along single rays. */
final class ReferenceFogSamples {
    /** Number of the sample of an area light, in turn. */
    private static final double GOLDEN = 0.6180339887498949;

    private final FogMedium medium;
    private final Fog fog;
    private final double scale;
    private final ReferenceFog.Visibility visibility;

    /** @param scale distance from the eye to the point that the camera looks at */
    ReferenceFogSamples(Scene scene, double scale, ReferenceFog.Visibility visibility) {
        medium = FogMedium.of(scene);
        fog = scene.world().fog();
        this.scale = scale;
        this.visibility = visibility;
    }

    /** Returns the places of samples along a ray. */
    FogPath path(LightSource source, Ray ray) {
        FogPath path = new FogPath();
        if (source.type().hasPosition()) {
            Vec3 light = source.position().minus(ray.origin());
            Vec3 d = ray.direction();
            path.aimAtPoint(light.x(), light.y(), light.z(), d.x(), d.y(), d.z(), scale);
        } else {
            path.aimAlong(scale);
        }
        return path;
    }

    /** Returns the light of each sample along a ray of a phase. */
    float[] parts(LightSource source, Ray ray, int phase) {
        FogPath path = path(source, ray);
        Vec3 d = ray.direction();
        SurfacePoint hit = visibility.surface(ray);
        double surface = path.place(hit == null ? Float.POSITIVE_INFINITY : (float) distance(ray.origin(), hit));
        float[] traced = new float[FogGrid.SAMPLES];
        for (int k = 0; k < FogGrid.SAMPLES; k++) {
            Vec3 at = point(ray, path.distance(FogGrid.place(k, phase)));
            float x = (float) at.x();
            float y = (float) at.y();
            float z = (float) at.z();
            LightSource sample = source.isArea() ? source.at(source.centerSamples(), 0, areaSample(source, k, phase)) : source;
            LightingEquation equation = new LightingEquation(sample);
            equation.moveTo(x, y, z, (float) d.x(), (float) d.y(), (float) d.z());
            double entering = passed(path, ray, k);
            double behind = FogGrid.place(k, phase) - surface;
            if (!(behind > 0 && behind < 1.0 / 16) && entering > 0 && equation.insideCone()
                    && visibility.isVisible(sample, new Vec3(x, y, z))) {
                double lost = lost(path, ray, k, phase, entering - passed(path, ray, k + 1));
                traced[k] = (float) (lost * (equation.falloff() * phase(equation.towardLight(d.x(), d.y(), d.z()))));
            }
        }
        return traced;
    }

    private static Vec3 point(Ray ray, double t) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return new Vec3(o.x() + t * d.x(), o.y() + t * d.y(), o.z() + t * d.z());
    }

    private static double distance(Vec3 from, SurfacePoint hit) {
        double dx = hit.px() - from.x();
        double dy = hit.py() - from.y();
        double dz = hit.pz() - from.z();
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** Returns what the fog absorbs in the length that a sample stands for. */
    private double lost(FogPath path, Ray ray, int k, int phase, double ofPart) {
        if (!path.isPoint()) {
            return ofPart;
        }
        double place = FogGrid.place(k, phase);
        double stands = path.slope(place) / FogGrid.SAMPLES;
        if (k == FogGrid.SAMPLES - 1) {
            double t = path.distance(place);
            Vec3 at = point(ray, t);
            return medium.densityAt(at.x(), at.y(), at.z()) * transmittance(ray, t) * stands;
        }
        double length = path.distance((k + 1.0) / FogGrid.SAMPLES) - path.distance((double) k / FogGrid.SAMPLES);
        return length > 0 ? ofPart / length * stands : 0;
    }

    private static int areaSample(LightSource source, int k, int phase) {
        double turn = (FogGrid.PHASES * k + phase) * GOLDEN;
        return (int) ((turn - Math.floor(turn)) * source.centerSamples().samples());
    }

    /** Returns what passes from the start of a part to the origin of the ray. */
    private double passed(FogPath path, Ray ray, int part) {
        return transmittance(ray, path.distance((double) part / FogGrid.SAMPLES));
    }

    /** Returns what the fog passes along a part of a ray. */
    double transmittance(Ray ray, double length) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        return FogMedium.transmittance(medium.depth(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), length));
    }

    /** Returns π times the phase function of Henyey and Greenstein. */
    private double phase(double cosine) {
        double g = fog.anisotropy();
        double square = 1 + g * g - 2 * g * cosine;
        return 0.25 * (1 - g * g) / (square * Math.sqrt(square));
    }
}

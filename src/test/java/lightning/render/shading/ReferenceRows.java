package lightning.render.shading;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/** Hit rows of a picture and their relation to each light, found ray by ray without a cache: the reference for the renderer's counts. */
public final class ReferenceRows {
    private final Scene scene;
    private final Geometry geometry;
    private final List<List<SurfacePoint>> levels = new ArrayList<>();

    public ReferenceRows(Scene scene) {
        this.scene = scene;
        geometry = Geometry.of(scene);
        PixelRays eye = new PixelRays(scene);
        List<Ray> rays = new ArrayList<>();
        for (int y = 0; y < scene.picture().height(); y++) {
            for (int x = 0; x < scene.picture().width(); x++) {
                rays.add(eye.ray(x, y));
            }
        }
        for (int k = 0; k <= scene.picture().depth(); k++) {
            levels.add(hits(rays));
            rays = levels.get(k).stream().filter(this::isMirror).map(SurfacePoint::reflectedRay).toList();
        }
    }

    private List<SurfacePoint> hits(List<Ray> rays) {
        List<SurfacePoint> hits = new ArrayList<>();
        for (Ray ray : rays) {
            int shape = BruteForce.nearest(geometry, ray);
            if (shape >= 0) {
                hits.add(geometry.surface(shape, ray));
            }
        }
        return hits;
    }

    /** Returns whether a refracted ray from the first level hits anything. */
    public boolean hasRefractedHits() {
        return rowsOfLevel(0).stream().filter(row -> row.backSide() != null).map(SurfacePoint::refractedRay)
                .anyMatch(ray -> ray != null && BruteForce.nearest(geometry, ray) >= 0);
    }

    /** Returns whether a row casts a mirrored ray. */
    public boolean isMirror(SurfacePoint row) {
        return geometry.materials().isReflective(row.material());
    }

    /** Returns the rows seen over {@code level} mirrors. */
    public List<SurfacePoint> rowsOfLevel(int level) {
        return levels.get(level);
    }

    /** Returns the number of rows of a level that match a predicate. */
    public long count(int level, Predicate<SurfacePoint> kind) {
        return rowsOfLevel(level).stream().filter(kind).count();
    }

    /** Returns the number of rows of all levels from {@code first} on. */
    public long rowsFrom(int first) {
        return levels.subList(first, levels.size()).stream().mapToLong(List::size).sum();
    }

    private LightingEquation equation(SurfacePoint p, Light light) {
        LightingEquation equation = new LightingEquation(LightSource.of(light, scene));
        equation.moveTo(p.px(), p.py(), p.pz(), p.nx(), p.ny(), p.nz());
        return equation;
    }

    /** Matches rows that face a light. */
    public Predicate<SurfacePoint> isFacing(Light light) {
        return p -> equation(p, light).cosine(p.nx(), p.ny(), p.nz()) > 0;
    }

    /** Matches rows inside a light's cone; all rows for a light without one. */
    public Predicate<SurfacePoint> isInsideCone(Light light) {
        return p -> equation(p, light).insideCone();
    }

    /** Matches rows that face a light inside its cone and need a shadow ray. */
    public Predicate<SurfacePoint> isReached(Light light) {
        return isFacing(light).and(isInsideCone(light));
    }

    /** Matches rows with an unblocked shadow ray to a light. */
    public Predicate<SurfacePoint> isUnblocked(Light light) {
        LightSource source = LightSource.of(light, scene);
        return p -> {
            Vec3 point = new Vec3(p.px(), p.py(), p.pz());
            return light.type().hasPosition()
                    ? !BruteForce.isBlocked(geometry, point, geometry.shadowRayTarget(source.position()))
                    : !BruteForce.isBlocked(geometry, new Ray(point, source.position()), Double.POSITIVE_INFINITY);
        };
    }

    /** Matches rows that a light lights. */
    public Predicate<SurfacePoint> isLit(Light light) {
        return isReached(light).and(isUnblocked(light));
    }

    /** Matches rows that face a light inside its cone but are in shadow. */
    public Predicate<SurfacePoint> isShadowed(Light light) {
        return isReached(light).and(isUnblocked(light).negate());
    }

    /** Matches rows that face a light and are outside its cone. */
    public Predicate<SurfacePoint> isOutsideCone(Light light) {
        return isFacing(light).and(isInsideCone(light).negate());
    }
}

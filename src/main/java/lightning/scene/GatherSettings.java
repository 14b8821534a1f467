package lightning.scene;

import java.util.Optional;
import lightning.base.text.Messages;
import lightning.scene.material.Material;

/**
 * Paths by which diffuse light is gathered: indirect light, the light of an environment, or both.
 *
 * @param bounces     diffuse bounces between a light and the surface that is seen; 0 if only the environment's own light is gathered
 * @param rays        rays by which a gather point collects light, as in {@link IndirectSettings}
 * @param spacing     distance of gather points, as in {@link IndirectSettings}
 * @param environment whether the scene has an environment, on or off, so that rays that leave it keep their direction
 * @param reflectionRays rays by which a point collects blurred reflections; 0 if no material blurs them
 */
public record GatherSettings(int bounces, int rays, int spacing, boolean environment, int reflectionRays) {

    /** Returns the paths that a scene needs; none without indirect light, the light of an environment and blurred reflections. */
    public static Optional<GatherSettings> of(Scene scene) {
        Optional<IndirectSettings> indirect = scene.picture().indirect();
        boolean reflections = scene.stage().rendered().materials().stream().anyMatch(Material::reflectsRoughly);
        if (indirect.isEmpty() && !scene.world().hasEnvironmentLight() && !reflections) {
            return Optional.empty();
        }
        IndirectSettings settings = indirect.orElse(IndirectSettings.DEFAULT);
        return Optional.of(new GatherSettings(indirect.isEmpty() ? 0 : settings.bounces(), settings.rays(), settings.spacing(),
                scene.world().hasEnvironment(), reflections ? scene.picture().reflectionRays() : 0));
    }

    /** Returns whether gather points are needed. */
    public boolean gathers() {
        return isIndirect() || environment;
    }

    /** Returns whether any material blurs its reflections. */
    public boolean reflections() {
        return reflectionRays > 0;
    }

    /** Returns the bounces of paths: reflections show surfaces that are lit. */
    public int pathBounces() {
        return reflections() ? Math.max(1, bounces) : bounces;
    }

    /** Returns the rays along each side of the square pattern of a reflection point, an even number. */
    public int reflectionRaysPerSide() {
        return (int) Math.round(Math.sqrt(reflectionRays));
    }

    /** Returns whether surfaces pass on light. */
    public boolean isIndirect() {
        return bounces > 0;
    }

    /**
     * Returns whether paths with these settings are paths for a scene too, which has the same shapes and camera. An environment that lights
     * nothing at present adds nothing, so its paths can stay.
     */
    public boolean canServe(Scene scene) {
        return of(scene).map(this::equals).orElse(bounces == 0 && !reflections() && scene.world().hasEnvironment());
    }

    /** Returns the distance of gather points in a picture, in its own pixels. */
    public double pixelSpacing(PictureSettings picture) {
        return spacing * IndirectSettings.pixelScale(picture);
    }

    /** Returns the rays along each side of the square pattern of a gather point: the square root of {@link #rays}. */
    public int raysPerSide() {
        return (int) Math.round(Math.sqrt(rays));
    }

    /**
     * Returns the rays along each side of the pattern of a surfel: the mean over many surfels needs few. It needs more where an environment lights
     * surfels only by these.
     */
    public int surfelRaysPerSide() {
        return environment ? raysPerSide() * 3 / 4 : raysPerSide() / 2;
    }

    /** Returns what is gathered, in words: {@code indirect light with 2 bounces, 64 rays, every 8 pixels}. */
    public String label() {
        return isIndirect() ? Messages.tr("indirect light with {0}", new IndirectSettings(bounces, rays, spacing, false).label())
                : environment ? Messages.tr("light of the environment with {0} rays, every {1} pixels", rays, spacing)
                : Messages.tr("blurred reflections with {0} rays, up to every {1} pixels",
                        reflectionRays, spacing);
    }
}

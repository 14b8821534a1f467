package lightning.document;

import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;

/** Small scene to edit: a ball on a mirror, and a light of each type. */
public final class DeskScene {
    public static final String TEXT = """
            jen 1
            # a comment that edits must not lose
            picture { size 40 30  depth 2 }
            camera { from 0 2 9  to 0 1 0  fov 40 }
            material mirror { diffuse 0.5 0.5 0.5  specular 0.2 0.2 0.2  reflective 0.4 0.4 0.4 }
            plane ground { material mirror  scale 20 1 20 }
            sphere ball { at 0 1 0 }
            light key spot { intensity 1  at 3 5 2  direction -3 -4 -2  angle 25  dropoff 4 }
            light fill point { intensity 0.5  at -3 2 4  attenuation 0.1 1 0.1 }
            light sun directional { intensity 0.3  direction -1 -1 -1  at 1 2 3 }
            """;

    private DeskScene() {}

    public static Scene scene() {
        try {
            return JenReader.read(TEXT, "desk.jen", Path.of("")).scene();
        } catch (JenException e) {
            throw new AssertionError(e);
        }
    }

    public static Light light(Scene scene, String name) {
        return scene.light(name).orElseThrow();
    }

    /** Returns the scene of an allowed edit. */
    public static Scene sceneOf(EditOutcome change) {
        return switch (change) {
            case EditOutcome.Applied to -> to.scene();
            case EditOutcome.Refused refused -> throw new AssertionError(refused.reason());
        };
    }

    /** Returns the parameter with that title. */
    public static AttributeNumber<?, ?> parameter(String name) {
        return AttributeNumber.ALL.stream().filter(d -> d.title().equals(name) || d.attribute().id().equals(name)).findFirst()
                .orElseThrow();
    }

    public static Light spot(Vec3 position, Vec3 direction) {
        return Light.of("spot", LightType.SPOT).withPosition(position).withDirection(direction);
    }

    public static List<String> names(Scene scene) {
        return scene.lights().stream().map(Light::name).toList();
    }
}

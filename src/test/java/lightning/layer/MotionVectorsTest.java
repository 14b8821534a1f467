package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Vec3;
import lightning.format.exr.ExrAttribute;
import lightning.sample.PythonPrograms;
import lightning.sample.StudioScene;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.LensShift;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Motion vectors of a written file: formulas of moves, and the matrices of the file's header. */
class MotionVectorsTest {
    private static final FrameTime TIME = new FrameTime(7, 24);
    private static final int SIZE = 40;
    private static final double FOV = 40;
    /** Pixels per unit of the image plane at distance 1. */
    private static final double SCALE = SIZE / (2 * Math.tan(Math.toRadians(FOV / 2)));
    /** Positions of at most 20 units are stored with an error of 2⁻²⁰, at a distance of at least 3. */
    private static final double ROUNDING = 20 * 0x1p-20 * SCALE / 3;

    @TempDir
    private Path folder;

    private static Scene scene(Placement placement) {
        Scene studio = StudioScene.of(LightType.POINT);
        return studio.withNodes(List.of(new Shape(Solid.PLANE, "wall", "matt", placement)))
                .withCamera(new Camera(new Vec3(0, 0, 10), Vec3.ZERO, Vec3.Y, FOV)).withPicture(studio.picture().withSize(SIZE, SIZE));
    }

    /** A wall in z = 0 that faces the camera, a square of 4 units. */
    private static Placement wall() {
        return new Placement(Vec3.ZERO, new Vec3(90, 0, 0), new Vec3(4, 1, 4));
    }

    private static ExrValues write(Scene scene, Scene previous, Scene next) throws IOException {
        return ExrValues.of(scene, Optional.of(new ShotFrame(TIME, previous, next)));
    }

    /** Checks the vectors of the hit pixels: to the previous place in the first two channels, from the next place in the others. */
    private static void assertVectors(ExrValues file, UnaryOperator<double[]> previous, UnaryOperator<double[]> next) {
        int hits = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            if (file.channel("shape.id")[i] > 0) {
                hits++;
                // Relative to the picture's center, y up.
                double[] place = {i % SIZE + 0.5 - SIZE / 2.0, SIZE / 2.0 - i / SIZE - 0.5};
                double[] before = previous.apply(place);
                double[] after = next.apply(place);
                assertThat((double) file.channel("vector.X")[i]).isCloseTo(before[0] - place[0], within(ROUNDING));
                assertThat((double) file.channel("vector.Y")[i]).isCloseTo(before[1] - place[1], within(ROUNDING));
                assertThat((double) file.channel("vector.Z")[i]).isCloseTo(place[0] - after[0], within(ROUNDING));
                assertThat((double) file.channel("vector.W")[i]).isCloseTo(place[1] - after[1], within(ROUNDING));
            }
        }
        assertThat(hits).isGreaterThan(100);
    }

    private static UnaryOperator<double[]> moved(double x, double y) {
        return place -> new double[] {place[0] + x, place[1] + y};
    }

    @Test
    void movedShape_movesItsPoints() throws IOException {
        Scene scene = scene(wall());
        ExrValues file =
                write(scene, scene(wall().withPosition(new Vec3(-0.5, 0.25, 0))), scene(wall().withPosition(new Vec3(1, 0.75, 0))));
        double pixelsPerUnit = SCALE / 10;
        assertVectors(file, moved(-0.5 * pixelsPerUnit, 0.25 * pixelsPerUnit), moved(pixelsPerUnit, 0.75 * pixelsPerUnit));
    }

    @Test
    void vectors_areThoseOfCycles() throws IOException {
        PythonPrograms.require("bpy", "OpenEXR");
        ExrValues file = write(scene(wall()), scene(wall().withPosition(new Vec3(-0.5, 0.25, 0))),
                scene(wall().withPosition(new Vec3(1, 0.75, 0))));
        Path script = Path.of("src/test/resources/lightning/layer/blender_vectors.py").toAbsolutePath();
        String text = PythonPrograms.output(folder, List.of(script.toString(), folder.resolve("vectors.exr").toString()));
        JsonNode cycles =
                new JsonMapper().readTree(text.substring(text.indexOf("RESULT ") + 7).lines().findFirst().orElseThrow());
        for (String axis : List.of("X", "Y", "Z", "W")) {
            assertThat((double) file.channel("vector." + axis)[20 * SIZE + 20]).isCloseTo(cycles.get(axis).asDouble(), within(1e-4));
        }
    }

    @Test
    void movedCamera_movesAllPointsBack() throws IOException {
        Scene scene = scene(wall());
        Vec3 right = new Vec3(0.4, 0, 0);
        Scene next = scene.withCamera(new Camera(scene.camera().from().plus(right), scene.camera().to().plus(right), Vec3.Y, FOV));
        assertVectors(write(scene, scene, next), moved(0, 0), moved(-0.4 * SCALE / 10, 0));
    }

    @Test
    void turnedAndScaledShape_turnsAndScalesItsPoints() throws IOException {
        Scene scene = scene(wall());
        double angle = Math.toRadians(10);
        Placement turn = new Placement(Vec3.ZERO, new Vec3(0, 0, 10), Vec3.ONE);
        Scene turned = scene.withNodes(List.of(new NodeGroup("turn", turn, List.of(scene.stage().shapes().getFirst()))));
        Scene scaled = scene(wall().withScale(new Vec3(6, 1, 6)));
        assertVectors(write(scene, turned, scaled),
                place -> new double[] {place[0] * Math.cos(angle) - place[1] * Math.sin(angle),
                    place[0] * Math.sin(angle) + place[1] * Math.cos(angle)},
                place -> new double[] {1.5 * place[0], 1.5 * place[1]});
    }

    @Test
    void nearerCamera_widensThePicture() throws IOException {
        Scene scene = scene(wall());
        Scene near = scene.withCamera(new Camera(new Vec3(0, 0, 8), Vec3.ZERO, Vec3.Y, FOV));
        Scene wide = scene.withCamera(new Camera(new Vec3(0, 0, 10), Vec3.ZERO, Vec3.Y, 60));
        double wideScale = Math.tan(Math.toRadians(20)) / Math.tan(Math.toRadians(30));
        assertVectors(write(scene, near, wide), place -> new double[] {place[0] * 1.25, place[1] * 1.25},
                place -> new double[] {place[0] * wideScale, place[1] * wideScale});
    }

    /** The camera turns and its lens shifts: still points move by the matrices that the neighbors' files have. */
    @Test
    void turnedCamera_agreesWithMatricesOfTheHeader() throws IOException {
        Scene scene = scene(wall());
        Scene next =
                scene.withCamera(new Camera(new Vec3(2, -1, 9), new Vec3(0.5, 0.2, 0), new Vec3(0.1, 1, 0), 50, new LensShift(0.1, -0.2)));
        ExrValues file = write(scene, scene, next);
        List<Float> m = ((ExrAttribute.Matrix) SceneMetadata.of(next, Optional.empty()).get("worldToNDC")).values();
        for (int i = 0; i < SIZE * SIZE; i++) {
            boolean hit = file.channel("shape.id")[i] > 0;
            // A point of the background is infinitely far: in direction of the pixel's ray, which ends at z = 0.
            double x = i % SIZE + 0.5 - SIZE / 2.0;
            double y = SIZE / 2.0 - i / SIZE - 0.5;
            double[] p = hit ? new double[] {file.channel("P.X")[i], file.channel("P.Y")[i], file.channel("P.Z")[i], 1}
                    : new double[] {x / SCALE, y / SCALE, -1, 0};
            double[] ndc = new double[4];
            for (int column = 0; column < 4; column++) {
                for (int row = 0; row < 4; row++) {
                    ndc[column] += p[row] * m.get(4 * row + column);
                }
            }
            // Directions of length 1 and floats of the matrix, below 4, give 2⁻²² of the picture's width for each product.
            double room = 16 * 0x1p-20 * SIZE;
            assertThat((double) file.channel("vector.Z")[i]).isCloseTo(i % SIZE + 0.5 - SIZE * ndc[0] / ndc[3], within(room));
            assertThat((double) file.channel("vector.W")[i]).isCloseTo(SIZE * ndc[1] / ndc[3] - i / SIZE - 0.5, within(room));
        }
    }

    @Test
    void stillFrame_hasZeros() throws IOException {
        Scene scene = StudioScene.of(LightType.POINT);
        ExrValues file = write(scene, scene, scene.withLights(List.of()));
        for (String axis : List.of("X", "Y", "Z", "W")) {
            assertThat(file.channel("vector." + axis)).containsOnly(0);
        }
    }

    /** The face of a light moves with its light. */
    @Test
    void faceOfMovedLight_moves() throws IOException {
        Scene wall = scene(wall().withPosition(new Vec3(0, -3, 0)));
        Light key = StudioScene.key(LightType.POINT);
        Light lamp = key.withName("lamp").withPosition(new Vec3(0, 1, 0)).withArea(key.area().withRadius(0.9)
                .withVisibility(FaceVisibility.GLOWING));
        Scene scene = wall.withLights(List.of(lamp));
        ExrValues file = write(scene, wall, wall.withLights(List.of(lamp.withPosition(new Vec3(1, 1, 0)))));
        int faces = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            boolean isFace = file.channel("shape.id")[i] == 0 && file.channel("Z")[i] < 1e10;
            faces += isFace ? 1 : 0;
            assertThat(file.channel("vector.X")[i]).isZero();
            // The ball's front is at most 0.9 nearer than its center.
            assertThat((double) file.channel("vector.Z")[i]).isBetween(isFace ? -SCALE / 9.1 : 0, isFace ? -SCALE / 10 : 0);
        }
        assertThat(faces).isGreaterThan(20);
    }

    @Test
    void stillPicture_hasNoVectors() throws IOException {
        assertThat(ExrValues.of(scene(wall()), Optional.empty()).values.keySet()).noneMatch(name -> name.startsWith("vector"));
    }
}

package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.format.jen.PropertyQuery;
import lightning.sample.EditSession;
import lightning.sample.SessionExporter;
import lightning.sample.TryFolder;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.SceneNode;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.statistics.Statistics;
import net.jqwik.api.statistics.StatisticsReport;
import tools.jackson.databind.node.ObjectNode;

/** Tests that after any sequence of requests the served picture has the bits of a fresh full trace of the edited scene. */
class ServedPictureTest {
    /** A step: an edit with numbers in place of {@code #}, or the name of a method. */
    private static final List<String> STEPS = List.of("key.color=# # #", "key.intensity=#", "key.at=# # -#", "key.type=spot",
            "key.type=directional", "key.type=point", "key.angle=2#", "key.area=disc", "key.radius=0.#", "key.on=no", "key.on=yes",
            "fill.direction=# -# #", "fill.color=# # #", "fill.casts_shadows=no", "fill.illuminates=ball", "fill.illuminates=all",
            "material:floor.diffuse=# # #", "material:mirror.reflective=# # #", "material:mirror.shininess=1#",
            "material:floor.reflective=# 0 #", "ball.at=# # #", "ball.scale=# 1 #", "ball.visible=no", "ball.visible=yes",
            "ball.material=floor",
            "world.ambience=#", "world.background=# # #", "camera.from=# 1 -5", "picture.depth=3", "picture.depth=0",
            "picture.antialias=edges",
            "picture.antialias=off", "picture.size=40 33", "picture.size=70 50", "picture.exposure=#", "undo", "undo", "redo", "render");

    @Provide
    Arbitrary<List<String>> steps() {
        Arbitrary<String> step = Arbitraries.of(STEPS).flatMap(text -> Arbitraries.integers().between(1, 9).list().ofSize(3)
                .map(digits -> fill(text, digits)));
        return step.list().ofMinSize(1).ofMaxSize(12);
    }

    private static String fill(String text, List<Integer> digits) {
        String filled = text;
        for (int digit : digits) {
            filled = filled.replaceFirst("#", text.contains("color") || text.contains("material:") || text.contains("world")
                    ? text.contains("shininess") ? "" + digit : "0." + digit : "" + digit);
        }
        return filled;
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void everyServedPicture_equalsAFullTrace(@ForAll("steps") List<String> steps) throws Exception {
        Path folder = Path.of("").toAbsolutePath();
        try (Server server = new Server(new ServerOptions(2, 500_000_000)); TestClient client = new TestClient(server)) {
            client.open(ServerTest.SCENE);
            // An independent model of the document: all states, and the present one.
            List<Scene> states = new ArrayList<>(List.of(JenReader.read(ServerTest.SCENE, "text", folder).scene()));
            int now = 0;
            for (String step : steps) {
                switch (step) {
                    case "undo" -> {
                        now = Math.max(0, now - 1);
                        client.request("undo", "'scene':1");
                    }
                    case "redo" -> {
                        now = Math.min(states.size() - 1, now + 1);
                        client.request("redo", "'scene':1");
                    }
                    case "render" -> assertThat(client.picture(1, "")).isEqualTo(ServerTest.trace(states.get(now)).toScanlines());
                    default -> {
                        Optional<Scene> edited = edited(states.get(now), step, folder);
                        String fields = "'scene':1,'edits':'" + step + "'";
                        if (edited.isEmpty()) {
                            client.refused("set", fields);
                        } else {
                            client.request("set", fields);
                            if (!edited.get().equals(states.get(now))) {
                                states.subList(now + 1, states.size()).clear();
                                states.add(edited.get());
                                now++;
                            }
                        }
                    }
                }
            }
            assertThat(client.picture(1, "")).isEqualTo(ServerTest.trace(states.get(now)).toScanlines());
        }
    }

    private static Optional<Scene> edited(Scene scene, String edit, Path folder) {
        try {
            return Optional.of(PropertyEdit.apply(scene, edit, folder));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    /** Random scenes of every kind, with random edits of lights, materials and objects in words. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void editsOfRandomScenes_equalFullTraces(@ForAll("sessions") EditSession session) throws Exception {
        try (TryFolder files = new TryFolder(); Server server = new Server(new ServerOptions(1, 500_000_000));
                TestClient client = new TestClient(server)) {
            Path folder = files.path();
            int count = session.scenes().size();
            SessionExporter.write(folder, session.scenes());
            client.request("open", "'file':'" + file(folder, 0) + "'");
            Scene current = JenReader.read(file(folder, 0)).scene();
            for (int k = 1; k < count; k++) {
                List<String> edits = differences(current, JenReader.read(file(folder, k)).scene());
                if (edits.isEmpty()) {
                    continue;
                }
                ObjectNode fields = JsonLines.JSON.createObjectNode().put("scene", 1);
                edits.forEach(fields.putArray("edits")::add);
                Optional<Scene> edited = Optional.of(current);
                for (String edit : edits) {
                    edited = edited.flatMap(scene -> edited(scene, edit, folder));
                }
                if (edited.isPresent()) {
                    client.request("set", fields);
                    current = edited.get();
                } else {
                    client.refused("set", fields);
                }
                Statistics.label("edits").collect(edited.isPresent() ? "applied" : "refused");
                assertThat(client.picture(1, "")).isEqualTo(ServerTest.trace(current).toScanlines());
            }
        }
    }

    private static Path file(Path folder, int number) {
        return folder.resolve(String.format(Locale.ROOT, "%02d.jen", number));
    }

    /** Returns edits for the attributes of lights, materials and objects by which two scenes differ. */
    private static List<String> differences(Scene from, Scene to) {
        List<String> edits = new ArrayList<>();
        for (Light light : to.lights()) {
            if (from.light(light.name()).isPresent()) {
                LightAttribute.ALL.forEach(a -> addDifference(from, to, name(light.name()) + "." + a.name(), edits));
            }
        }
        for (Material material : to.materials()) {
            if (from.material(material.name()).isPresent()) {
                MaterialAttribute.ALL.forEach(a -> addDifference(from, to, "material:" + name(material.name()) + "." + a.name(), edits));
            }
        }
        for (SceneNode node : to.nodes()) {
            if (from.stage().node(node.name()).isPresent()) {
                List.of("at", "rotate", "scale", "visible").forEach(p -> addDifference(from, to, name(node.name()) + "." + p, edits));
            }
        }
        return edits;
    }

    private static String name(String name) {
        return name.matches("[A-Za-z_]\\w*") ? name : '"' + name + '"';
    }

    private static void addDifference(Scene from, Scene to, String reference, List<String> edits) {
        String after = PropertyQuery.get(to, reference);
        if (!after.equals(PropertyQuery.get(from, reference))) {
            edits.add(reference + "=" + after);
        }
    }
}

package lightning.accuracy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import lightning.math.Rgb;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Scene;

/**
 * Edits of materials, which the paper leaves as future work (§5.2). Each edits the first material on a shape that has
 * what it needs, and is left out where none has.
 */
final class MaterialCases {
    private static final Predicate<Material> ANY = m -> true;
    private static final Predicate<Material> TEXTURED = m -> m.texture().isPresent();

    private final List<PaperCase> cases = new ArrayList<>();
    private final Scene scene;
    private final List<Material> used;

    private MaterialCases(Scene scene) {
        this.scene = scene;
        used = scene.placedShapes().stream().map(shape -> shape.material()).distinct().toList();
    }

    static List<PaperCase> of(Scene scene) {
        var builder = new MaterialCases(scene);
        Predicate<Material> mirrors = m -> scene.picture().depth() > 0 && !m.reflective().isBlack();
        builder.edit("material-color", ANY, m -> m.withDiffuse(m.diffuse().times(0.5)));
        builder.edit("shininess", m -> !m.specular().isBlack(), m -> m.withShininess(Math.min(m.shininess() * 2 + 1, Limits.MAX_SHININESS)));
        builder.edit("reflectivity", mirrors, m -> m.withReflective(m.reflective().times(0.5)));
        builder.edit("mirror-off", mirrors, m -> m.withReflective(Rgb.BLACK));
        builder.backFrom("mirror-on", mirrors, m -> m.withReflective(Rgb.BLACK));
        builder.edit("texture-off", TEXTURED, m -> m.withTexture(Optional.empty()));
        builder.backFrom("texture-on", TEXTURED, m -> m.withTexture(Optional.empty()));
        return builder.cases;
    }

    private void edit(String name, Predicate<Material> needed, UnaryOperator<Material> edit) {
        edited(needed, edit).ifPresent(after -> add(name, after));
    }

    private void backFrom(String name, Predicate<Material> needed, UnaryOperator<Material> edit) {
        edited(needed, edit).ifPresent(between -> add(name, between, scene));
    }

    private Optional<Scene> edited(Predicate<Material> needed, UnaryOperator<Material> edit) {
        return used.stream().filter(needed).findFirst().map(m -> scene.withMaterial(edit.apply(m)));
    }

    private void add(String name, Scene... steps) {
        List<Scene> scenes = new ArrayList<>(List.of(scene));
        scenes.addAll(Arrays.asList(steps));
        cases.add(new PaperCase(name, "", Double.NaN, scenes));
    }
}

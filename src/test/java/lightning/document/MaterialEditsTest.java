package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.Scene;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MaterialEditsTest {
    private final Scene scene = DeskScene.scene();

    private static Material after(EditOutcome change, String name) {
        return DeskScene.sceneOf(change).material(name).orElseThrow();
    }

    @Test
    void edit_changesItsProperty() {
        Material mirror = scene.material("mirror").orElseThrow();
        assertThat(after(MaterialEdits.set(scene, "mirror", MaterialAttribute.AMBIENT, Rgb.WHITE), "mirror"))
                .isEqualTo(mirror.withAmbient(Rgb.WHITE));
        assertThat(after(MaterialEdits.set(scene, "mirror", MaterialAttribute.DIFFUSE, Rgb.WHITE), "mirror"))
                .isEqualTo(mirror.withDiffuse(Rgb.WHITE));
        assertThat(after(MaterialEdits.set(scene, "mirror", MaterialAttribute.SPECULAR, Rgb.WHITE), "mirror"))
                .isEqualTo(mirror.withSpecular(Rgb.WHITE));
        assertThat(after(MaterialEdits.set(scene, "mirror", MaterialAttribute.SHININESS, 3.0), "mirror"))
                .isEqualTo(mirror.withShininess(3));
        assertThat(after(MaterialEdits.set(scene, "mirror", MaterialAttribute.REFLECTIVE, Rgb.BLACK), "mirror"))
                .isEqualTo(mirror.withReflective(Rgb.BLACK));
    }

    @Test
    void texture_isReadFromSceneFolderAndRemoved() {
        Scene wood = DeskScene.sceneOf(MaterialEdits.setTexture(scene, "mirror", MaterialAttribute.TEXTURE, "wood.png", Path.of("scenes")));
        TextureMap map = wood.material("mirror").orElseThrow().texture().orElseThrow();
        Scene repeated = DeskScene.sceneOf(MaterialEdits.set(wood, "mirror", MaterialAttribute.TEXTURE,
                Optional.of(new TextureMap(map.file(), 2, 3, map.image()))));
        assertThat(repeated.material("mirror").orElseThrow().texture().orElseThrow().repeatV()).isEqualTo(3);
        assertThat(DeskScene.sceneOf(MaterialEdits.set(repeated, "mirror", MaterialAttribute.TEXTURE, Optional.empty()))).isEqualTo(scene);
    }

    @Test
    void impossibleEdits_areRefused() {
        assertThat(MaterialEdits.set(scene, "miror", MaterialAttribute.SHININESS, 3.0).refusal()).contains("material 'miror' not found");
        assertThat(MaterialEdits.set(scene, "mirror", MaterialAttribute.SHININESS, -3.0).refusal())
                .contains("shininess must be ≥ 0, was -3");
        assertThat(MaterialEdits.set(scene, "mirror", MaterialAttribute.DIFFUSE, new Rgb(0, 2, 0)).refusal())
                .contains("diffuse green must be from 0 to 1, was 2");
        assertThat(
                MaterialEdits.setTexture(scene, "mirror", MaterialAttribute.TEXTURE, "none.png", Path.of("scenes")).refusal().orElseThrow())
                .contains("there is no texture 'none.png'");
        assertThat(
                MaterialEdits.setTexture(scene, "mirror", MaterialAttribute.TEXTURE, "../wood.png", Path.of("scenes")).refusal()
                        .orElseThrow())
                .contains("without empty names, . and ..");
    }

    @Test
    void shapeWithoutMaterial_getsDefaultOnEdit() {
        assertThat(MaterialEdits.ofShape(scene, "ball")).contains(Material.DEFAULT);
        assertThat(MaterialEdits.ofShape(scene, "ground")).isEqualTo(scene.material("mirror"));
        assertThat(MaterialEdits.ofShape(scene, "key")).isEmpty();
        Scene edited = DeskScene.sceneOf(MaterialEdits.set(scene, "default", MaterialAttribute.SHININESS, 5.0));
        assertThat(MaterialEdits.ofShape(edited, "ball")).contains(Material.DEFAULT.withShininess(5));
    }

    @Test
    void edits_areUndoableLabeledAndSaved(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT);
        OpenDocument document = OpenDocument.open(file);
        document.apply(MaterialEdits.set(document.scene(), "mirror", MaterialAttribute.SHININESS, 5.0));
        assertThat(document.history().undoLabel()).contains("mirror: shininess 16 → 5");
        document.apply(MaterialEdits.set(document.scene(), "default", MaterialAttribute.DIFFUSE, new Rgb(1, 0, 0)));
        assertThat(document.history().undoLabel()).contains("default: diffuse 0.8 0.8 0.8 → 1 0 0");
        document.history().undo();
        TestSaves.save(document);
        assertThat(Files.readString(file)).isEqualTo(DeskScene.TEXT.replace("0.4 0.4 0.4 }", "0.4 0.4 0.4  shininess 5 }"));
        document.history().undo();
        assertThat(document.scene()).isEqualTo(scene);
    }

    @Test
    void severalProperties_areLabeledWithoutValues() {
        var history = new EditHistory(scene);
        history.edit(DeskScene.sceneOf(MaterialEdits.edit(scene, "mirror", m -> m.withShininess(5).withReflective(Rgb.BLACK))));
        assertThat(history.undoLabel()).contains("mirror: shininess, reflective");
    }
}

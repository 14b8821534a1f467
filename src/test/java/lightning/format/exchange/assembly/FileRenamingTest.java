package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.format.jen.ReferencedFiles;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import org.junit.jupiter.api.Test;

/** Tests that a scene's files are found and renamed in all attributes that refer to files. */
class FileRenamingTest {
    private static final Texture IMAGE = new Texture(1, 1, new float[3]);

    /** Returns a scene with a file in each attribute, named by the attribute. */
    private static Scene sceneWithAllFiles() {
        // A model that has all maps.
        Material material = Material.of("m").withModel(ShadingModel.PRINCIPLED);
        for (MaterialAttribute<Optional<TextureMap>> map : MaterialAttribute.MAPS) {
            material = map.with(material, Optional.of(new TextureMap(map.name() + ".png", 2, 3, IMAGE)));
        }
        Light light = Light.of("key", LightType.SPOT).withGobo(Optional.of(new Gobo("gobo.png", IMAGE)))
                .withProfile(Optional.of(new IesProfile("lamp.ies", null)))
                .withTexture(Optional.of(new LightTexture("film.png", IMAGE)));
        World world = World.DEFAULT.withEnvironment(
                Optional.of(new Environment("sky.hdr", new EnvironmentMap(1, 1, new float[] {1, 1, 1}))));
        Camera camera = new Camera(new Vec3(0, 0, 5), Vec3.ZERO, Vec3.Y, 40);
        return new Scene(PictureSettings.DEFAULT, camera, world, List.of(material), List.of(), List.of(light));
    }

    private static List<String> files(Scene scene) {
        List<String> files = new ArrayList<>();
        scene.materials().forEach(m -> MaterialAttribute.ALL.forEach(attribute -> attribute.file(m).ifPresent(files::add)));
        scene.lights().forEach(l -> LightAttribute.ALL.forEach(attribute -> attribute.file(l).ifPresent(files::add)));
        World.ATTRIBUTES.forEach(attribute -> attribute.file(scene.world()).ifPresent(files::add));
        return files;
    }

    @Test
    void files_areRenamedInAllAttributes() {
        Scene scene = sceneWithAllFiles();
        assertThat(files(scene)).contains("texture.png", "glow_map.png", "bump.png", "normal_map.png", "cutout.png", "gobo.png", "lamp.ies",
                "film.png", "sky.hdr");

        Scene renamed = new FileRenaming(name -> "new/" + name).applyTo(scene);

        assertThat(files(renamed)).isEqualTo(files(scene).stream().map(name -> "new/" + name).toList());
        assertThat(new FileRenaming(name -> name.substring(4)).applyTo(renamed)).isEqualTo(scene);
    }

    @Test
    void textures_areThoseOfMaterialsAndFaces() {
        List<String> maps = MaterialAttribute.MAPS.stream().map(map -> map.name() + ".png").toList();
        assertThat(ReferencedFiles.textures(sceneWithAllFiles())).containsAll(maps).contains("film.png").doesNotContain("gobo.png")
                .hasSize(maps.size() + 1);
    }
}

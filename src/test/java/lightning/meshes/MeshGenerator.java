package lightning.meshes;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** Generator of all sample meshes and the landscape. */
public final class MeshGenerator {
    private MeshGenerator() {}

    /** @param args the folder of the scenes */
    public static void main(String[] args) throws IOException {
        Path meshes = Files.createDirectories(Path.of(args[0], "meshes"));
        for (Map.Entry<String, ParametricSurface> body : SampleSolids.all().entrySet()) {
            body.getValue().write(meshes.resolve(body.getKey() + ".ply"));
        }
        Files.writeString(Path.of(args[0], "landscape.jen"), LandscapeScene.text());
    }
}

package lightning.format.assimp;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.lwjgl.assimp.AIMaterial;
import org.lwjgl.assimp.AIScene;
import org.lwjgl.assimp.Assimp;

/** Textures of materials that Assimp does not write to glTF. */
final class TextureLosses {
    private static final Map<Integer, String> NAMES = new LinkedHashMap<>();

    static {
        NAMES.put(Assimp.aiTextureType_SPECULAR, "specular");
        NAMES.put(Assimp.aiTextureType_SHININESS, "shininess");
        NAMES.put(Assimp.aiTextureType_AMBIENT, "ambient");
        NAMES.put(Assimp.aiTextureType_OPACITY, "opacity");
        NAMES.put(Assimp.aiTextureType_HEIGHT, "bump");
        NAMES.put(Assimp.aiTextureType_DISPLACEMENT, "displacement");
        NAMES.put(Assimp.aiTextureType_REFLECTION, "reflection");
    }

    private TextureLosses() {}

    /** Returns a line for each kind of texture that a scene has: its name, a tab and the number of materials with it. */
    static List<String> of(AIScene scene) {
        List<String> lines = new ArrayList<>();
        NAMES.forEach((type, name) -> {
            int count = 0;
            for (int i = 0; i < scene.mNumMaterials(); i++) {
                AIMaterial material = AIMaterial.create(requireNonNull(scene.mMaterials()).get(i));
                count += Assimp.aiGetMaterialTextureCount(material, type) > 0 ? 1 : 0;
            }
            if (count > 0) {
                lines.add(name + " textures of materials\t" + count);
            }
        });
        return lines;
    }
}

package lightning.format.exchange.usd;

import java.util.List;
import java.util.Optional;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Prim above a light that is hidden in the stage, because this prim or one above it is invisible. A comment of the scene file stores it as
 * JSON.
 *
 * @param path its path
 * @param isHidden whether it is invisible itself
 * @param children paths of the outermost prims below it that can be hidden and are not; empty if they are too many
 */
public record UsdHiddenParent(String path, boolean isHidden, Optional<List<String>> children) {
    /** Start of the comment. */
    static final String COMMENT = "usd hidden: ";
    private static final JsonMapper JSON = JsonMapper.builder().build();

    public UsdHiddenParent {
        children = children.map(List::copyOf);
    }

    /** Returns the comment of a prim. */
    static String comment(JsonValue in) throws MeshException {
        return COMMENT + in.node();
    }

    /** Returns what a comment says; empty if it has been damaged. */
    static Optional<UsdHiddenParent> parse(String comment) {
        try {
            JsonNode in = JSON.readTree(comment.substring(COMMENT.length()));
            String path = in.path("path").asString("");
            Optional<List<String>> children = in.path("children").isArray()
                    ? Optional.of(in.path("children").valueStream().map(v -> path + "/" + v.asString("")).toList()) : Optional.empty();
            boolean isValid = UsdPaths.isWritable(path) && children.stream().flatMap(List::stream).allMatch(UsdPaths::isWritable);
            return isValid ? Optional.of(new UsdHiddenParent(path, in.path("hidden").asBoolean(false), children)) : Optional.empty();
        } catch (JacksonException e) {
            return Optional.empty();
        }
    }
}

package lightning.format.exchange.json;

import lightning.base.text.RefusalException;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.scene.Dome;
import lightning.scene.World;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** JSON form of the domes of a world: an array of objects with a name and all attributes. */
public final class DomeJson {
    private static final String KEY = "domes";

    private DomeJson() {}

    /** Writes the domes of a world, if it has any. */
    public static void write(ObjectNode out, World world) {
        if (!world.named().isEmpty()) {
            ArrayNode domes = out.putArray(KEY);
            world.named().forEach(dome -> AttributeJson.write(domes.addObject().put("name", dome.name()), dome, Dome.ATTRIBUTES));
        }
    }

    /**
     * Adds the domes to the world of a scene, renamed if their names are taken.
     *
     * @param onError runs for each value that cannot be used
     */
    static void read(JsonNode in, SceneAssembler assembler, Runnable onError) {
        for (JsonNode json : in.path(KEY)) {
            try {
                Dome blank = Dome.of(assembler.names.unique(json.path("name").asString(""), "dome"));
                assembler.addDome(AttributeJson.read(json, blank, Dome.ATTRIBUTES, assembler::hasOrCopiesFile, _ -> onError.run()));
            } catch (RefusalException e) {
                onError.run();
            }
        }
    }
}

package lightning.cli;

import lightning.jen.PropertyEdit;
import lightning.scene.Scene;
import picocli.CommandLine.Option;

/** One word of an edit on the command line; exactly one of the fields is set. */
final class EditStep {
    @Option(names = "--set", required = true, paramLabel = "NAME.PROPERTY=VALUE",
            description = "Sets a property as the file would: key.intensity=0.4, \"key.color=1 0 0\", key.type=spot, key.on=no, world.ambience=0.1, picture.depth=5.")
    private String set;

    @Option(names = "--add", required = true, paramLabel = "LIGHT",
            description = "Adds a light, as in \"fill point intensity=0.5 at=0 3 2\".")
    private String add;

    @Option(names = "--delete", required = true, paramLabel = "LIGHT", description = "Deletes a light.")
    private String delete;

    @Option(names = "--then", required = true, description = "Renders; what follows is the next edit.")
    private boolean then;

    /** Whether this step ends a group. */
    boolean endsGroup() {
        return then;
    }

    /**
     * The scene after this step.
     *
     * @throws BadInput if the scene has no such thing, or not such a value
     */
    Scene apply(Scene scene) throws BadInput {
        try {
            return set != null ? PropertyEdit.apply(scene, set)
                    : add != null ? PropertyEdit.add(scene, add)
                    : delete != null ? PropertyEdit.delete(scene, delete)
                    : scene;
        } catch (IllegalArgumentException e) {
            String step = set != null ? "--set " + set : add != null ? "--add " + add : "--delete " + delete;
            throw new BadInput(step + ": " + e.getMessage());
        }
    }
}

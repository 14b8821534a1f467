package lightning.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Quote;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import picocli.CommandLine.Option;

/** One word of an edit on the command line; exactly one of the fields is set. */
final class EditStep {
    @Option(names = "--set", required = true, paramLabel = "NAME.PROPERTY=VALUE",
            description = {
                "Sets a property as the file would: key.intensity=0.4, \"key.color=1 0 0\", key.type=spot, key.on=no, world.ambience=0.1, picture.depth=5;",
                "a name that is no word in double quotes, '\"key light\".intensity=2';",
                "of a material: \"material:gold.reflective=0.5 0.4 0.1\", material:gold.shininess=30, material:floor.texture=none."})
    private String set;

    @Option(names = "--add", required = true, paramLabel = "LIGHT",
            description = "Adds a light, as in \"fill point intensity=0.5 at=0 3 2\".")
    private String add;

    @Option(names = "--delete", required = true, paramLabel = "LIGHT", description = "Deletes a light.")
    private String delete;

    @Option(names = "--case", required = true, paramLabel = "NAME",
            description = "Makes one of the paper's edits by its name in the tour, as color or angle-larger.")
    private String paperCase;

    @Option(names = "--then", required = true, description = "Renders; what follows is the next edit.")
    private boolean then;

    /** Splits steps at each {@code --then} into the groups of one edit each, at least one; a group may be empty. */
    static List<List<EditStep>> splitGroups(List<EditStep> steps) {
        List<List<EditStep>> groups = new ArrayList<>();
        groups.add(new ArrayList<>());
        for (EditStep step : steps) {
            if (step.then) {
                groups.add(new ArrayList<>());
            } else {
                groups.getLast().add(step);
            }
        }
        return groups;
    }

    /**
     * The scenes that this step leads to, one after the other; all but the last are rendered by themselves.
     *
     * @param folder where textures are looked for
     * @throws BadInputException if the scene has no such thing, or not such a value
     */
    List<Scene> apply(Scene scene, Path folder) throws BadInputException {
        if (paperCase != null) {
            return paperCase(scene);
        }
        try {
            return List.of(set != null ? PropertyEdit.apply(scene, set, folder)
                    : add != null ? PropertyEdit.add(scene, add)
                    : PropertyEdit.delete(scene, delete));
        } catch (IllegalArgumentException e) {
            String step = set != null ? "--set " + set : add != null ? "--add " + add : "--delete " + delete;
            throw new BadInputException(Quote.shorten(step) + ": " + e.getMessage());
        }
    }

    /**
     * Remarks on each property that was set and does nothing to the edited picture.
     *
     * @param group the steps of the edit
     * @param after the scene after the edit
     */
    static void warnUnused(List<EditStep> group, Scene after, Console console) {
        group.stream().filter(step -> step.set != null).flatMap(step -> PropertyEdit.ineffectiveReason(after, step.set).stream())
                .distinct().forEach(why -> console.warn("%s", why));
    }

    private List<Scene> paperCase(Scene scene) throws BadInputException {
        List<PaperCase> cases = PaperCases.of(scene);
        for (PaperCase edit : cases) {
            if (edit.name().equals(paperCase)) {
                return edit.scenes().subList(1, edit.scenes().size());
            }
        }
        throw new BadInputException("--case " + Quote.shorten(paperCase) + ": expected one of "
                + String.join(", ", cases.stream().map(PaperCase::name).toList()) + ", which this scene allows");
    }
}

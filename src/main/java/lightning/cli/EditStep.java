package lightning.cli;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** One edit option of the command line; exactly one of the fields is set. */
final class EditStep {
    @Option(names = "--set", required = true, paramLabel = "NAME.PROPERTY=VALUE",
            description = {
                "Set a property with the syntax of the scene file: key.intensity=0.4, \"key.color=1 0 0\", key.type=spot, key.on=no, "
                        + "world.ambience=0.1, picture.depth=5.",
                "Quote names that are not a single word: '\"key light\".intensity=2'.",
                "Materials: \"material:gold.reflective=0.5 0.4 0.1\", material:gold.shininess=30, material:floor.texture=none."})
    private @Nullable String set;

    @Option(names = "--add", required = true, paramLabel = "LIGHT",
            description = "Add a light, such as \"fill point intensity=0.5 at=0 3 2\".")
    private @Nullable String add;

    @Option(names = "--delete", required = true, paramLabel = "LIGHT", description = "Delete a light.")
    private @Nullable String delete;

    @Option(names = "--case", required = true, paramLabel = "NAME",
            description = "Apply one of the paper's edits by its name in 'lightning tour', such as color or angle-larger.")
    private @Nullable String paperCase;

    @Option(names = "--then", required = true, description = "Start a new group of edits.")
    private boolean then;

    /** Splits steps at each {@code --then} into groups, at least one; a group may be empty. */
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
     * Returns the scenes that this step produces, in order; all but the last are rendered separately.
     *
     * @param folder folder of the textures
     * @throws BadInputException if the scene has no such name or property, or the value is invalid
     */
    List<Scene> apply(Scene scene, Path folder) throws BadInputException {
        if (paperCase != null) {
            return paperCase(scene);
        }
        try {
            return List.of(set != null ? PropertyEdit.apply(scene, set, folder)
                    : add != null ? PropertyEdit.add(scene, add)
                    : PropertyEdit.delete(scene, requireNonNull(delete)));
        } catch (RefusalException e) {
            String step = set != null ? "--set " + set : add != null ? "--add " + add : "--delete " + delete;
            throw new BadInputException(Quote.shorten(step) + ": " + e.getMessage());
        }
    }

    /**
     * Prints a note for each property of the group that has no effect on the edited image.
     *
     * @param group steps of the edit
     * @param after scene after the edit
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
        throw new BadInputException("--case " + Quote.shorten(requireNonNull(paperCase)) + ": expected one of "
                + String.join(", ", cases.stream().map(PaperCase::name).toList()) + ", the cases of this scene");
    }
}

package lightning.editor.window.welcome;

import java.util.List;
import java.util.function.BiPredicate;
import lightning.base.text.Messages;
import lightning.editor.Command;

/**
 * Short lesson in the open scene.
 *
 * @param title English title
 * @param summary English sentence about what is learned
 */
record Lesson(String title, String summary, List<Step> steps) {
    /**
     * Step of a lesson.
     *
     * @param text English sentence that says what to do; {@code {0}}, {@code {1}} … are the keys of the commands
     * @param isDone compares the moments when the step began and now
     */
    record Step(String text, List<Command> commands, BiPredicate<LessonMoment, LessonMoment> isDone) {}

    static final List<Lesson> ALL = List.of(
            new Lesson(Messages.key("Move a light"), Messages.key("Drag a light and see its exact picture"), List.of(
                    new Step(Messages.key("Drag the yellow light in the preview, or drag the arrow next to its intensity."),
                            List.of(), (start, now) -> now.hasOtherLights(start)),
                    new Step(Messages.key("The ray-traced picture follows. Press {0} to compare it with a full trace, pixel by pixel."),
                            List.of(Command.VERIFY), (_, now) -> now.hasRun(Command.VERIFY)),
                    new Step(Messages.key("The status line shows the verdict. Press {0} to undo your edit."),
                            List.of(Command.UNDO), (_, now) -> now.hasRun(Command.UNDO)))),
            new Lesson(Messages.key("Place a rim light"), Messages.key("Drag light in the picture itself"), List.of(
                    new Step(Messages.key("Press {0} to add a light."),
                            List.of(Command.ADD_LIGHT), (start, now) -> now.scene().lights().size() > start.scene().lights().size()),
                    new Step(Messages.key("Press {0} to place it as a rim light."),
                            List.of(Command.PLACE_RIM), (_, now) -> now.hasRun(Command.PLACE_RIM)),
                    new Step(Messages.key("Drag along the edge of an object in the ray-traced picture: the light moves behind it."),
                            List.of(), (start, now) -> now.hasOtherLights(start)),
                    new Step(Messages.key("Drag the ring to change the light's distance, or drag its arrow of intensity."),
                            List.of(), (start, now) -> now.hasOtherLights(start)))),
            new Lesson(Messages.key("Mix lights, keep a look"), Messages.key("Mix without tracing a ray, and store the result"), List.of(
                    new Step(Messages.key("Press {0} to open the light mixer."), List.of(Command.MIXER),
                            (_, now) -> now.hasRun(Command.MIXER)),
                    new Step(Messages.key("Drag a fader: the picture follows without tracing a ray."), List.of(),
                            (start, now) -> now.hasOtherLights(start)),
                    new Step(Messages.key("Press {0} to save the scene: looks are stored next to it."), List.of(Command.SAVE_SCENE),
                            (_, now) -> !now.state().untitled()),
                    new Step(Messages.key("Press {0}, type a name and choose Save Look."), List.of(Command.LOOKS),
                            (start, now) -> now.savedLooks() > start.savedLooks()))),
            new Lesson(Messages.key("Paint with light"), Messages.key("Say how the picture shall change, and let the lights follow"),
                    List.of(
                            new Step(Messages.key("Press {0} to open Match Reference."), List.of(Command.MATCH_REFERENCE),
                                    (_, now) -> now.hasRun(Command.MATCH_REFERENCE)),
                            new Step(Messages.key("Choose Brighter, paint where the picture shall be brighter, and click Match."),
                                    List.of(),
                                    (start, now) -> now.hasOtherLights(start)),
                            new Step(Messages.key("Press {0} to undo. Or open an image that the picture shall resemble."),
                                    List.of(Command.UNDO),
                                    (_, now) -> now.hasRun(Command.UNDO)))),
            new Lesson(Messages.key("Share your light"), Messages.key("Show the picture in a browser, with a fader for each light"),
                    List.of(
                            new Step(Messages.key("Choose File > Live Review…"), List.of(),
                                    (_, now) -> now.hasRun(Command.LIVE_REVIEW)),
                            new Step(Messages.key(
                                    "Click Start Review and Copy, and open the address in a browser. Then move a light here: the page follows."),
                                    List.of(), (start, now) -> now.hasOtherLights(start)),
                            new Step(Messages.key("Press {0} to undo. The review ends when you close its panel."), List.of(Command.UNDO),
                                    (_, now) -> now.hasRun(Command.UNDO)))));
}

package lightning.editor.window.model;

import java.util.List;
import lightning.editor.Command;
import lightning.editor.window.model.WindowLayout.CanvasLayout;

/** Arrangement of pictures and panels for a kind of work. */
public enum ArrangementPreset {
    /** Lights are placed and mixed. */
    LIGHT(Command.ARRANGE_LIGHT, CanvasLayout.SIDE_BY_SIDE, List.of(Command.MIXER), false),
    /** Looks are compared in a large picture. */
    COMPARE(Command.ARRANGE_COMPARE, CanvasLayout.PICTURE_ALONE, List.of(Command.SCOPES, Command.LOOKS, Command.CONTRIBUTIONS), false),
    /** Keyframes are set along the timeline. */
    SHOT(Command.ARRANGE_SHOT, CanvasLayout.PICTURE_LARGE, List.of(Command.TIMELINE), true);

    private final Command command;
    private final CanvasLayout canvases;
    private final List<Command> panels;
    private final boolean filmStrip;

    /** @param panels docked panels; the first of each dock is in front */
    ArrangementPreset(Command command, CanvasLayout canvases, List<Command> panels, boolean filmStrip) {
        this.command = command;
        this.canvases = canvases;
        this.panels = panels;
        this.filmStrip = filmStrip;
    }

    /** Returns the command that applies the preset. */
    public Command command() {
        return command;
    }

    /** Shows the preset's panels at their usual places and closes all others. */
    void apply(WindowLayout layout) {
        layout.panelsHiddenProperty().set(false);
        layout.canvasLayoutProperty().set(canvases);
        layout.filmStripShownProperty().set(filmStrip);
        PanelArrangement arrangement = PanelArrangement.INITIAL;
        for (Command panel : panels.reversed()) {
            arrangement = arrangement.open(panel);
        }
        layout.panelsProperty().set(arrangement);
    }
}

package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.Command;
import org.junit.jupiter.api.Test;

/** Places of the panels: opening, closing, moving, and the line in the preferences. */
class PanelArrangementTest {
    private static final PanelArrangement NONE = PanelArrangement.INITIAL;

    @Test
    void openedPanel_isInFront() {
        PanelArrangement both = NONE.open(Command.MIXER).open(Command.LOOKS);
        assertThat(both.openIn(PanelPlace.BELOW)).containsExactly(Command.MIXER, Command.LOOKS);
        assertThat(both.front(PanelPlace.BELOW)).contains(Command.LOOKS);
        assertThat(both.isShown(Command.MIXER)).isFalse();
        assertThat(both.inFront(Command.MIXER).isShown(Command.MIXER)).isTrue();
    }

    @Test
    void closedFront_givesWayToNeighbor() {
        PanelArrangement three = NONE.open(Command.MIXER).open(Command.CONTRIBUTIONS).open(Command.LOOKS);
        assertThat(three.close(Command.LOOKS).front(PanelPlace.BELOW)).contains(Command.CONTRIBUTIONS);
        assertThat(three.close(Command.MIXER).front(PanelPlace.BELOW)).contains(Command.LOOKS);
        assertThat(three.closeAll().front(PanelPlace.BELOW)).isEmpty();
    }

    @Test
    void tornOffPanel_remembersItsDock() {
        PanelArrangement torn = NONE.move(Command.MIXER, PanelPlace.LEFT).move(Command.MIXER, PanelPlace.WINDOW);
        assertThat(torn.place(Command.MIXER)).isEqualTo(PanelPlace.WINDOW);
        assertThat(torn.dock(Command.MIXER)).isEqualTo(PanelPlace.LEFT);
        assertThat(torn.isShown(Command.MIXER)).isTrue();
        assertThat(torn.openIn(PanelPlace.LEFT)).isEmpty();
        assertThat(torn.close(Command.MIXER).open(Command.MIXER).place(Command.MIXER)).isEqualTo(PanelPlace.WINDOW);
    }

    @Test
    void text_restoresArrangement() {
        PanelArrangement used = NONE.open(Command.MIXER).open(Command.LOOKS).move(Command.SCOPES, PanelPlace.WINDOW)
                .move(Command.HISTORY_PANEL, PanelPlace.BELOW).inFront(Command.MIXER).move(Command.CONTRIBUTIONS, PanelPlace.LEFT)
                .close(Command.CONTRIBUTIONS);
        assertThat(PanelArrangement.parse(used.format())).isEqualTo(used);
    }

    @Test
    void textOfOtherVersion_isReadAsFarAsPossible() {
        assertThat(PanelArrangement.parse("")).isEqualTo(NONE);
        PanelArrangement read = PanelArrangement.parse("RADAR:BELOW:FRONT,LOOKS:NOWHERE:OPEN,LOOKS:LEFT,:,MIXER");
        assertThat(read.openIn(PanelPlace.BELOW)).containsExactly(Command.LOOKS);
        assertThat(read.slots()).hasSameSizeAs(NONE.slots());
    }

    @Test
    void preset_closesOtherPanels() {
        var layout = new WindowLayout();
        layout.panelsHiddenProperty().set(true);
        layout.panelsProperty().set(NONE.move(Command.UPDATES_PANEL, PanelPlace.WINDOW));
        ArrangementPreset.COMPARE.apply(layout);
        assertThat(layout.panelsHiddenProperty().get()).isFalse();
        assertThat(layout.panelsProperty().get().openIn(PanelPlace.WINDOW)).isEmpty();
        assertThat(layout.panelsProperty().get().openIn(PanelPlace.LEFT)).containsExactly(Command.SCOPES);
        assertThat(layout.panelsProperty().get().front(PanelPlace.BELOW)).contains(Command.LOOKS);
    }

    @Test
    void timelineShown_followsArrangementAndSetsIt() {
        var layout = new WindowLayout();
        layout.timelineShownProperty().set(true);
        assertThat(layout.panelsProperty().get().isShown(Command.TIMELINE)).isTrue();
        layout.panelsProperty().set(layout.panelsProperty().get().open(Command.MIXER));
        assertThat(layout.timelineShownProperty().get()).as("behind the mixer").isFalse();
        layout.timelineShownProperty().set(true);
        assertThat(layout.panelsProperty().get().front(PanelPlace.BELOW)).contains(Command.TIMELINE);
        layout.timelineShownProperty().set(false);
        assertThat(layout.panelsProperty().get().front(PanelPlace.BELOW)).contains(Command.MIXER);
    }
}

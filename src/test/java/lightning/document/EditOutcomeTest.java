package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import lightning.base.text.RefusalException;
import org.junit.jupiter.api.Test;

class EditOutcomeTest {
    @Test
    void refusedValue_isARefusal() {
        assertThat(EditOutcome.of(() -> {
            throw new RefusalException("no room");
        }).refusal()).contains("no room");
    }

    @Test
    void bug_isNoRefusal() {
        IllegalArgumentException bug = new IllegalArgumentException("channel 3");
        assertThatThrownBy(() -> EditOutcome.of(() -> {
            throw bug;
        })).isSameAs(bug);
    }
}

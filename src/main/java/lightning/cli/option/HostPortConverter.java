package lightning.cli.option;

import lightning.base.text.RefusalException;
import lightning.shot.cluster.HostPort;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Parses the address of a cluster member. */
public final class HostPortConverter implements ITypeConverter<HostPort> {
    @Override
    public HostPort convert(String text) {
        try {
            return HostPort.parse(text);
        } catch (RefusalException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }
}

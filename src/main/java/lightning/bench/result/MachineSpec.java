package lightning.bench.result;

/**
 * Hardware and software of the measuring machine.
 *
 * @param system      operating system and instruction set
 * @param processor   processor model; {@code unknown} if the system does not report it
 * @param processors  number of available processors
 * @param vectorBits  vector width, bits
 * @param memoryBytes physical memory, bytes
 * @param heapBytes   maximum heap, bytes
 * @param java        name and version of the Java VM
 */
public record MachineSpec(String system, String processor, int processors, int vectorBits, long memoryBytes, long heapBytes, String java) {}
